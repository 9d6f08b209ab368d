// Tests several programs of app/cli that write the same files at once.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"

#include <QDir>
#include <QLockFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <filesystem>
#include <memory>
#include <vector>

using namespace rubble;

namespace {

constexpr int kProcesses = 8;  // of each kind

int roundCount() { return qEnvironmentVariableIsSet("RUBBLE_LONG") ? 100 : 2; }

/// Programs that run at the same time.
class Programs {
public:
    void start(const QStringList& arguments) {
        m_running.push_back(std::make_unique<QProcess>());
        m_running.back()->start(RUBBLE_CLI, arguments);
    }
    /// Returns what those that failed wrote to standard error.
    QByteArray errors() {
        QByteArray errors;
        for (const auto& program : m_running) {
            const bool hasEnded = program->waitForFinished(kPatience);
            if (!hasEnded || program->exitStatus() != QProcess::NormalExit || program->exitCode() != 0)
                errors += "failed: " + program->readAllStandardError();
        }
        m_running.clear();
        return errors;
    }

private:
    std::vector<std::unique_ptr<QProcess>> m_running;
};

}  // namespace

class ParallelTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> m_place;
    QString at(const char* name) const { return m_place->filePath(name); }
    QStringList entries(const QString& folder) const {
        return QDir(folder).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }

private slots:
    void init() {
        m_place = std::make_unique<QTemporaryDir>();
        for (const char* name : {"wall.rubble", "other.rubble"})
            QCOMPARE(QProcess::execute(RUBBLE_CLI, {"new", at(name)}), 0);
    }
    void everyExportAndImportCounts() {
        QFile::remove(at("other.rubble"));
        for (int round = 0; round < roundCount(); ++round) {
            Programs programs;
            for (int k = 0; k < kProcesses; ++k) {
                programs.start(
                    {"export", at("wall.rubble"), "--out", at("packs"), "--format", k % 2 == 0 ? "obj" : "glb"});
                programs.start(
                    {"import", RUBBLE_SOURCE_DIR "/tests/data/meshes/pair.glb", "--into", at("other.rubble")});
            }
            const QByteArray errors = programs.errors();
            QVERIFY2(errors.isEmpty(), errors);
            QCOMPARE(entries(at("packs")), (QStringList{"export.json", "scene.json", "wall"}));
            QProcess check;
            check.start(RUBBLE_CLI, {"check", at("packs"), at("other.rubble")});
            QVERIFY(check.waitForFinished(kPatience));
            const QByteArray fault = check.readAllStandardOutput() + check.readAllStandardError();
            QVERIFY2(check.exitCode() == 0, fault);
            const Result<Project> project = loadProject(at("other.rubble").toStdString());
            QVERIFY(project);
            QCOMPARE(static_cast<int>(project->assets.size()), 2 * kProcesses);  // the mesh holds two objects
            QCOMPARE(entries(m_place->path()), (QStringList{"other.rubble", "packs", "wall.rubble"}));
            QFile::remove(at("other.rubble"));
        }
    }
    /// Names of one file, in one folder or several: hard links, and links to them.
    void importsByAnyNameOfAProjectCount() {
        const std::string project = at("other.rubble").toStdString();
        for (int round = 0; round < 5 * roundCount(); ++round) {
            QFile::remove(at("other.rubble"));
            QCOMPARE(QProcess::execute(RUBBLE_CLI, {"new", at("other.rubble")}), 0);
            QVERIFY(QDir(m_place->path()).mkpath("sub"));
            QStringList names{at("other.rubble"), at("second.rubble"), at("sub/third.rubble"), at("sub/link.rubble")};
            for (const QString& name : names.mid(1)) QFile::remove(name);
            std::filesystem::create_hard_link(project, names[1].toStdString());
            std::filesystem::create_hard_link(project, names[2].toStdString());
            std::filesystem::create_symlink("third.rubble", names[3].toStdString());
            Programs programs;
            for (const QString& name : names)
                programs.start({"import", RUBBLE_SOURCE_DIR "/tests/data/meshes/pair.glb", "--into", name});
            const QByteArray errors = programs.errors();
            QVERIFY2(errors.isEmpty(), errors);
            const Result<Project> saved = loadProject(project);
            QVERIFY2(saved, saved ? "" : saved.error().message.c_str());
            QCOMPARE(saved->assets.size(), std::size_t{1 + 2 * 4});  // the first wall, and two objects of each import
            QCOMPARE(entries(at("sub")), (QStringList{"link.rubble", "third.rubble"}));
        }
    }
    void oneOfSeveralNewProjectsIsCreated() {
        QFile::remove(at("wall.rubble"));
        std::vector<std::unique_ptr<QProcess>> programs;
        for (int k = 0; k < kProcesses; ++k) {
            programs.push_back(std::make_unique<QProcess>());
            programs.back()->start(RUBBLE_CLI, {"new", at("wall.rubble")});
        }
        int created = 0;
        for (const auto& program : programs) {
            QVERIFY(program->waitForFinished(kPatience));
            created += program->exitCode() == 0 ? 1 : 0;
        }
        QCOMPARE(created, 1);
    }
    /// The editor holds such a lock while a project is open.
    void projectThatIsOpenElsewhereIsNotChanged() {
        QLockFile lock(at(".wall.rubble.lock"));
        lock.setStaleLockTime(0);
        QVERIFY(lock.tryLock(0));
        QFile file(at("wall.rubble"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray before = file.readAll();
        for (const QStringList& arguments :
             {QStringList{"import", RUBBLE_SOURCE_DIR "/tests/data/meshes/pair.glb"},
              QStringList{"seeds", RUBBLE_SOURCE_DIR "/tests/data/meshes/wall.stl", "--asset", "wall"},
              QStringList{"seeds", "--density", RUBBLE_SOURCE_DIR "/tests/data/densities/crack.png", "--asset",
                          "wall"}}) {
            QProcess program;
            program.start(RUBBLE_CLI, arguments + QStringList{"--into", at("wall.rubble")});
            QVERIFY(program.waitForFinished(kPatience));
            QCOMPARE(program.exitCode(), 1);
            const QByteArray error = program.readAllStandardError();
            QVERIFY2(error.contains("\" is already open in ") && error.endsWith("Save and close it there first.\n"),
                     error);
            file.seek(0);
            QCOMPARE(file.readAll(), before);
        }
    }
};

RUBBLE_TEST_WITH(ParallelTest, QCoreApplication)
#include "ParallelTest.moc"
