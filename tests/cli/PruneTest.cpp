// Tests export --prune in app/cli/verbs/ExportVerb.cpp where recorded cases cannot: links, several programs at once.
#include "core/io/output/ExportIndex.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

using namespace rubble;

namespace fs = std::filesystem;

class PruneTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_place;
    fs::path m_packs;

    /// Writes the project, whose asset has a name, and exports it. `isNew`: it is another asset.
    ProgramOutcome exportAs(const std::string& name, const QStringList& more = {}, bool isNew = false) {
        Project project = boxProject(UniformScatter{.count = 3});
        project.assets[0].name = name;
        if (isNew) project.instances[0].asset = project.assets[0].id = project.nextId++;
        const QString file = m_place->filePath("box.rubble");
        if (!saveProject(file.toStdString(), project)) qFatal("cannot save");
        return runProgram(RUBBLE_CLI, QStringList{"export", file, "--out", m_place->filePath("packs")} + more);
    }
    std::vector<std::string> listed() const { return (**readExportIndex(m_packs)).folders; }

private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>();
        m_packs = m_place->filePath("packs").toStdString();
    }
    void renamedAssetTakesItsFolderAlong() {
        QCOMPARE(exportAs("Wall").exit, 0);
        QCOMPARE(exportAs("gate").exit, 0);
        QVERIFY(!fs::exists(m_packs / "Wall") && fs::exists(m_packs / "gate"));
        QVERIFY(listed() == std::vector<std::string>{"gate"});
    }
    void deletedAssetIsPruned() {
        QCOMPARE(exportAs("Wall").exit, 0);
        QCOMPARE(exportAs("gate", {}, true).exit, 0);
        QVERIFY((listed() == std::vector<std::string>{"gate", "Wall"}));
        QCOMPARE(exportAs("gate", {"--prune"}, true).exit, 0);
        QVERIFY(!fs::exists(m_packs / "Wall") && fs::exists(m_packs / "gate"));
        QVERIFY(listed() == std::vector<std::string>{"gate"});
    }
    /// As on a file system that ignores case, of which a link takes the place here.
    void folderOfAnAssetIsNotPrunedByAnotherName() {
        QCOMPARE(exportAs("Wall").exit, 0);
        fs::create_directory_symlink("Wall", m_packs / "wall");
        const ProgramOutcome outcome = exportAs("wall", {"--prune"});
        QVERIFY2(outcome.exit == 0, qPrintable(outcome.error));
        QVERIFY(fs::exists(m_packs / "wall" / "pack.json"));
        QVERIFY(listed() == std::vector<std::string>{"wall"});
    }
    void linksAreNotPruned() {
        QCOMPARE(exportAs("Wall").exit, 0);
        fs::rename(m_packs / "Wall", m_place->filePath("elsewhere").toStdString());
        fs::create_directory_symlink("../elsewhere", m_packs / "Wall");
        const ProgramOutcome outcome = exportAs("gate", {"--prune"});
        QCOMPARE(outcome.exit, 1);
        QVERIFY2(outcome.error.contains("is a link, which is not followed"), qPrintable(outcome.error));
        QVERIFY(fs::exists(m_packs / "Wall" / "pack.json"));
    }
    /// Programs that export one asset each at the same time: the index lists all.
    void everyExportIsListed() {
        Project project = boxProject(UniformScatter{.count = 3});
        const Asset asset = project.assets[0];
        QStringList names;
        for (Id k = 0; k < 6; ++k) {
            project.assets.push_back(asset);
            project.assets.back().id = 100 + k;
            project.assets.back().name = "part " + std::to_string(k);
            project.assets.back().pattern.layers[0].id = 200 + k;
            names.append(QString::fromStdString(project.assets.back().name));
        }
        project.nextId = 300;
        const QString file = m_place->filePath("box.rubble");
        QVERIFY(saveProject(file.toStdString(), project));
        std::vector<std::unique_ptr<QProcess>> programs;
        for (const QString& name : names) {
            programs.push_back(std::make_unique<QProcess>());
            programs.back()->start(RUBBLE_CLI,
                                   {"export", file, "--out", m_place->filePath("packs"), "--asset", name, "-q"});
        }
        for (const auto& program : programs) {
            QVERIFY(program->waitForFinished(kPatience));
            QVERIFY2(program->exitCode() == 0, program->readAllStandardError());
        }
        QCOMPARE(listed().size(), static_cast<std::size_t>(names.size()));
    }
};

RUBBLE_TEST(PruneTest)
#include "PruneTest.moc"
