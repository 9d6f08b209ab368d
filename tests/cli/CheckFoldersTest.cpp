// Tests app/cli/verbs/CheckVerb.cpp and core/io/output/ExportFolder.cpp: folders of packs, names and links in them.
#include "app/cli/Cli.h"
#include "core/io/pack/OutputFolder.h"
#include "core/io/pack/PackExport.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/RunProgram.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>

using namespace rubble;

namespace {

namespace fs = std::filesystem;

/// A run of rubble-cli check.
struct CheckRun {
    int exit = -1;
    QString out, err;
};

void write(const fs::path& path, const QByteArray& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), bytes.size());
}

CheckRun check(const fs::path& path) {
    std::ostringstream out, err;
    const int exit = runCli({"check", path.string()}, {.in = 0, .out = out, .err = err});
    return {exit, QString::fromStdString(out.str()), QString::fromStdString(err.str())};
}

}  // namespace

class CheckFoldersTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_place;
    fs::path m_packs;

    /// Exports an asset with a name.
    void exportAsset(const std::string& name, EditedFiles edited = EditedFiles::Kept) {
        Project project = boxProject(UniformScatter{.count = 3});
        project.assets[0].name = name;
        const auto exported = exportPacks(project, std::vector{project.assets[0].id}, m_packs, {}, edited);
        QVERIFY(exported.hasValue() && exported->size() == 1);
        m_status = (*exported)[0].status;
    }
    Status m_status = success();
    CheckRun m_check;

private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>();
        m_packs = m_place->filePath("packs").toStdString();
    }
    void scenesOfOtherExportsAreFound() {
        Project project = boxProject(UniformScatter{.count = 3});
        project.instances.push_back({.id = project.nextId++, .name = "box 1", .asset = project.assets[0].id});
        exportAsset(project.assets[0].name);
        write(m_packs / kSceneName, QByteArray::fromStdString(sceneFileJson(project, {})));
        for (const fs::path& path : {m_packs, m_packs / kSceneName}) QCOMPARE(check(path).exit, 0);
        project.assets[0].prism().depth *= 2.0;
        write(m_packs / kSceneName, QByteArray::fromStdString(sceneFileJson(project, {})));
        for (const fs::path& path : {m_packs, m_packs / kSceneName}) {
            const CheckRun run = check(path);
            QCOMPARE(run.exit, 3);
            QVERIFY2(run.err.contains("is of another export than the scene"), qPrintable(run.err));
        }
    }
    void gapsThatLeaveNothingAreFaults() {
        Project project = boxProject(UniformScatter{.count = 30});
        const fs::path file = m_place->filePath("box.rubble").toStdString();
        for (const auto& [gap, exit] : {std::pair(0.001, 0), {50.0, 3}}) {
            project.assets[0].shaping.gap = gap;
            QVERIFY(saveProject(file, project));
            const CheckRun run = check(file);
            QCOMPARE(run.exit, exit);
            QCOMPARE(run.err.contains("The gap between fragments leaves none of them"), exit == 3);
        }
    }
    void editedScenesAreReported() {
        Project project = boxProject(UniformScatter{.count = 3});
        project.instances.push_back({.id = project.nextId++, .name = "box 1", .asset = project.assets[0].id});
        const std::vector assets{project.assets[0].id};
        QVERIFY(exportToFolder({.folder = m_packs, .project = "box.rubble"}, project, assets)->finished);
        QVERIFY(!check(m_packs).err.contains("was changed"));
        const std::string scene = readFile(m_packs / kSceneName).value();
        write(m_packs / kSceneName, QByteArray::fromStdString(scene) + "\n");
        const CheckRun run = check(m_packs);
        QCOMPARE(run.exit, 0);
        QVERIFY2(run.err.contains("scene.json: It was changed after the export."), qPrintable(run.err));
    }
    void namesThatAreTooLongAreWarnedOf() {
        Project project = boxProject(UniformScatter{.count = 3});
        const auto warnings = [&](std::size_t length) {
            project.assets[0].name = std::string(length, 'w');
            const fs::path path = m_place->filePath("p.rubble").toStdString();
            write(path, QByteArray::fromStdString(projectText(project)));
            return check(path).err;
        };
        QVERIFY(!warnings(61).contains("Blender"));
        QVERIFY(warnings(62).contains("Blender cuts names at 63 bytes"));
        QVERIFY(!warnings(62).contains("Windows"));
        QVERIFY(warnings(150).contains("Windows opens paths of 260 at most"));
    }
    void assetsMayHaveTheNamesOfFiles_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"manifest.json", "pack.json", "wall.obj", "pack", "x.import"})
            QTest::newRow(name) << name;
    }
    void assetsMayHaveTheNamesOfFiles() {
        QFETCH(QString, name);
        exportAsset("roof");
        exportAsset(name.toStdString());
        QVERIFY(m_status.hasValue());
        for (const fs::path& path :
             {m_packs, m_packs / name.toStdString(), m_packs / name.toStdString() / "pack.json"}) {
            const CheckRun run = check(path);
            QVERIFY2(run.exit == 0, qPrintable(run.err));
            QVERIFY2(run.out.contains(name + ": 3 fragments"), qPrintable(run.out));
        }
        exportAsset(name.toStdString());  // unchanged
        QVERIFY(m_status.hasValue());
    }
    /// What a killed export left, and a running one has written so far.
    void foldersOfExportsAreNoPacks() {
        exportAsset("wall");
        for (const char* name : {".rubble-17-0123456789abcdef.tmp", ".rubble-18-0123456789abcdef.old"}) {
            fs::create_directory(m_packs / name);
            write(m_packs / name / "pack.json", "{\"format\": \"rubb");
        }
        const CheckRun run = check(m_packs);
        QCOMPARE(run.err, QString());
        QCOMPARE(run.exit, 0);
        fs::create_directory(m_packs / ".rubble-of-a-user");
        write(m_packs / ".rubble-of-a-user/pack.json", "{");
        QCOMPARE(check(m_packs).exit, 1);
    }
    void linksInPacksAreReportedAndNotFollowed_data() {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"wall-fragments.obj", "wall.mtl", "pack.json", "manifest.json", "wall.obj.import", "more.txt"})
            QTest::newRow(name) << name;
    }
    void linksInPacksAreReportedAndNotFollowed() {
        QFETCH(QString, name);
        exportAsset("wall");
        const fs::path link = m_packs / "wall" / name.toStdString(), target = m_packs / "secret";
        const QByteArray secret = fs::exists(link) ? bytesOfFile(QString::fromStdString(link)) : "secret";
        write(target, secret);
        fs::remove(link);
        fs::create_symlink(target, link);  // with the very bytes that the manifest lists
        const CheckRun run = check(m_packs);
        QCOMPARE(run.exit, name == "pack.json" ? 1 : 3);  // a linked pack.json is not read
        QVERIFY2(run.err.contains(name + "\""), qPrintable(run.err));
        if (name == "wall.obj.import" || name == "more.txt") return;  // an unchanged export does not look at more files
        exportAsset("wall");
        QVERIFY2(!m_status.hasValue(), "the export took the link for the file");
        QVERIFY(fs::is_symlink(link));
        if (name != "wall-fragments.obj" && name != "wall.mtl") return;
        exportAsset("wall", EditedFiles::Replaced);
        QVERIFY2(m_status.hasValue(), m_status.hasValue() ? "" : m_status.error().message.c_str());
        QVERIFY(!fs::is_symlink(link));
        QCOMPARE(bytesOfFile(QString::fromStdString(target)), secret);
        QCOMPARE(check(m_packs).exit, 0);
    }
    /// A prism of a disc has two corners for each of the outline's.
    void hullsOfManyCornersAreReported() {
        const auto checkDisc = [&](int corners, const QStringList& options) {
            Project project = boxProject(UniformScatter{.count = 1});
            Ring& outline = project.assets[0].prism().outline.outer;
            outline.clear();
            for (int k = 0; k < corners; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / corners;
                outline.emplace_back(std::cos(angle), std::sin(angle));
            }
            fs::remove_all(m_packs);
            QVERIFY(exportPacks(project, std::vector{project.assets[0].id}, m_packs, {}).hasValue());
            std::ostringstream out, err;
            std::vector<std::string> arguments{"check", m_packs.string()};
            for (const QString& option : options) arguments.push_back(option.toStdString());
            const int exit = runCli(arguments, {.in = 0, .out = out, .err = err});
            m_check = {exit, QString::fromStdString(out.str()), QString::fromStdString(err.str())};
        };
        checkDisc(32, {});
        QCOMPARE(m_check.err, QString());
        checkDisc(40, {"--strict"});
        QCOMPARE(m_check.exit, 0);  // a note
        QVERIFY2(m_check.err.contains("has 80 corners: PhysX simulates"), qPrintable(m_check.err));
        checkDisc(200, {});
        QCOMPARE(m_check.exit, 0);
        QVERIFY2(m_check.err.contains("has 400 corners: PhysX, and with it Unity"), qPrintable(m_check.err));
        checkDisc(200, {"--strict"});
        QCOMPARE(m_check.exit, 3);
    }
    void namesThatImportersActUponAreReported() {
        fs::create_directories(m_packs);
        write(m_packs / "leaf.mtl", "newmtl leaf_alpha\nnewmtl bark\n");
        write(m_packs / "leaf.obj",
              "mtllib leaf.mtl\no leaf\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
              "usemtl bark\nf 4 3 2 1\nusemtl leaf_alpha\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        const std::string project = (m_packs / "leaf.rubble").string(), packs = (m_packs / "packs").string();
        std::ostringstream out, err;
        const auto run = [&](std::vector<std::string> arguments) {
            err.str({});
            return runCli(arguments, {.in = 0, .out = out, .err = err});
        };
        const QString leaf = QString::fromStdString((m_packs / "leaf.obj").string());
        QCOMPARE(runProgram(RUBBLE_CLI, {"import", leaf, "--into", QString::fromStdString(project)}).exit, 0);
        QVERIFY2(run({"export", project, "--out", packs, "-q"}) == 0, err.str().c_str());
        for (const std::string& place : {project, packs}) {
            QCOMPARE(run({"check", place}), 0);
            QVERIFY2(err.str().find("\"leaf_alpha\" and makes it transparent") != std::string::npos, err.str().c_str());
            QCOMPARE(run({"check", place, "--strict"}), 3);
        }
    }
    void danglingLinksAreReported() {
        exportAsset("wall");
        fs::remove(m_packs / "wall/wall-fragments.obj");
        fs::create_symlink("nowhere", m_packs / "wall/wall-fragments.obj");
        const CheckRun run = check(m_packs / "wall");
        QCOMPARE(run.exit, 3);
        QVERIFY2(run.err.contains("is a link"), qPrintable(run.err));
    }
};

RUBBLE_TEST_WITH(CheckFoldersTest, QCoreApplication)
#include "CheckFoldersTest.moc"
