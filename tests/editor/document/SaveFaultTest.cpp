// Tests editor/document/DocumentFile.cpp and editor/document/Autosave.cpp: no work is lost when a save fails. Each call
// to the file system that opening, backing up and saving a project make fails once, and the program is killed before
// each.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "editor/document/Autosave.h"
#include "editor/document/DocumentFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Faults.h"
#include "tests/support/files/FileTree.h"

#include <QTemporaryDir>
#include <QTest>

#include <cerrno>
#include <cstdlib>
#include <filesystem>

using namespace rubble;

namespace {

constexpr const char* kSavingFolder = "RUBBLE_SAVING_CHILD";
enum Exit { kSaved, kNotSaved, kNotOpened };

Project projectAt(double height) {
    Project project = starterProject();
    project.identity = "0123456789abcdef0123456789abcdef";  // else the first save gives one
    project.ground.height = height;
    return project;
}

QByteArray bytesOf(const Project& project) { return QByteArray::fromStdString(projectText(project)); }

/// Opens, edits, backs up and saves a project, and ends without closing it, as if it went on and was killed later.
[[noreturn]] void editAndSave(const QString& folder) {
    Document document(emptyProject());
    DocumentFile file(document);
    Autosave autosave(document, folder + "/backups");
    QObject::connect(&file, &DocumentFile::originChanged, &autosave, &Autosave::setOrigin);
    if (!file.open(folder + "/wall.rubble")) std::_Exit(kNotOpened);
    SceneSettings scene = sceneSettings(document.project());
    scene.ground.height = 3.0;
    document.push({.text = "Move ground", .replacements = {scene}});
    autosave.writeNow();
    std::_Exit(file.save() ? kSaved : kNotSaved);
}

}  // namespace

class SaveFaultTest : public QObject {
    Q_OBJECT
public:
    /// As a child process, this program saves instead of testing.
    static void initMain() {
        if (!qEnvironmentVariableIsSet(kSavingFolder)) return;
        int argumentCount = 0;
        const QCoreApplication program(argumentCount, nullptr);
        editAndSave(qEnvironmentVariable(kSavingFolder));
    }

private slots:
    void initTestCase() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("The library with the faults cannot be loaded before that of the sanitizer.");
#endif
    }
    void workIsInTheFileOrInTheBackup_data() {
        QTest::addColumn<int>("code");
        QTest::addColumn<bool>("hasLinks");
        for (const bool hasLinks : {false, true}) {
            const char* links = hasLinks ? ", hard links" : "";
            QTest::addRow("full disk%s", links) << ENOSPC << hasLinks;
            QTest::addRow("failing disk%s", links) << EIO << hasLinks;
            QTest::addRow("killed%s", links) << 0 << hasLinks;
        }
    }
    void workIsInTheFileOrInTheBackup() {
        QFETCH(int, code);
        QFETCH(bool, hasLinks);
        const QByteArray before = bytesOf(projectAt(1.0));
        const QByteArray after = bytesOf(projectAt(3.0));
        for (int call = 1;; ++call) {
            const QTemporaryDir place;
            const QString folder = QFileInfo(place.path()).canonicalFilePath() + "/files";
            writeFileTree(folder, {{"wall.rubble", before}});
            if (hasLinks)
                std::filesystem::create_hard_link((folder + "/wall.rubble").toStdString(),
                                                  place.filePath("link").toStdString());
            QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
            environment.insert(kSavingFolder, folder);
            const FaultyRun run = runWithFault(
                QCoreApplication::applicationFilePath(), {"SaveFaultTest"}, RUBBLE_FAULTS,
                {.folder = folder, .report = place.filePath("report"), .call = call, .code = code}, environment);
            if (run.failed.isEmpty()) {
                QCOMPARE(run.outcome.exit, int{kSaved});
                QVERIFY(call > 20);
                break;
            }
            checkFolder(folder, before, after, run, "call " + QByteArray::number(call) + ", " + run.failed.toUtf8());
        }
    }

private:
    static void checkFolder(const QString& folder, const QByteArray& before, const QByteArray& after,
                            const FaultyRun& run, const QByteArray& where) {
        const FileTree files = fileTree(folder);
        const QByteArray project = files["wall.rubble"];
        const QByteArray copy = files["wall.rubble.before-save"];
        const bool isKilled = run.outcome.exit == -1;
        const bool isInterrupted = isKilled && isInterruptedSave(project.toStdString()) && copy == before;
        bool isBackedUp = false;
        for (auto file = files.begin(); file != files.end(); ++file) {
            const bool isBackup = file.key().startsWith("backups/") && file.key().endsWith(".rubble");
            isBackedUp = isBackedUp || (isBackup && file.value() == after);
        }
        QVERIFY2(project == before || project == after || isInterrupted, where);
        if (run.outcome.exit == kSaved) QVERIFY2(project == after, where);
        if (run.outcome.exit == kNotOpened) QVERIFY2(project == before, where);
        if (run.outcome.exit == kNotSaved || isInterrupted) QVERIFY2(isBackedUp, where);
        QVERIFY2(copy.isEmpty() || copy == before, where);  // it stays if it cannot be removed; the next save does
    }
};

RUBBLE_TEST_WITH(SaveFaultTest, QCoreApplication)
#include "SaveFaultTest.moc"
