// Tests that a full disk, a failing disk and a kill of app/cli leave files as they were before or as they are to be:
// each call to the file system that a save and an export make fails once, and the program is killed before each.
#include "core/asset/library/StarterProject.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Faults.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileTree.h"

#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <cerrno>

using namespace rubble;

namespace {

/// The files without those that a killed process may leave: temporary ones and locks.
FileTree visibleOf(const FileTree& tree) {
    FileTree visible;
    for (auto file = tree.begin(); file != tree.end(); ++file) {
        if (!file.key().startsWith('.') && !file.key().contains("/.")) visible[file.key()] = file.value();
    }
    return visible;
}

/// The files in the output folder itself, which an export writes after the packs: the scene, and the index before and
/// after it.
constexpr const char* kIndex = "export.json";
constexpr const char* kScene = "scene.json";

FileTree packsOf(FileTree tree) {
    tree.remove(kIndex);
    tree.remove(kScene);
    return tree;
}

/// Whether packs are in place, and the scene is the old or the new one. The index may list both; that the next export
/// replaces what is listed is tested.
bool isBeforeIndex(const FileTree& visible, const FileTree& before, const FileTree& after) {
    const QByteArray scene = visible.value(kScene);
    return packsOf(visible) == packsOf(after) && (scene == before.value(kScene) || scene == after.value(kScene));
}

void replaceFileTree(const QString& folder, const FileTree& tree) {
    QVERIFY(QDir(folder).removeRecursively() && QDir().mkpath(folder));
    writeFileTree(folder, tree);
}

enum class Renames { All, Plain };  // plain: without flags, as on network file systems

}  // namespace

class FaultTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_place;
    QString m_folder;
    QString m_report;

    QStringList inFolder(QStringList words) const {
        for (QString& word : words) word.replace("{folder}", m_folder);
        return words;
    }

    FaultyRun runCall(const QStringList& command, int call, int code, Renames renames) const {
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        if (renames == Renames::Plain) environment.insert("RUBBLE_FAULT_NO_FLAGS", "1");
        const Fault fault{.folder = m_folder, .report = m_report, .call = call, .code = code};
        return runWithFault(RUBBLE_CLI, inFolder(command), RUBBLE_FAULTS, fault, environment);
    }

    /// Lets each call of a command fail, on a folder with the files `before`.
    void checkEveryCall(const QStringList& command, const FileTree& before, int code, Renames renames) {
        replaceFileTree(m_folder, before);
        const ProgramOutcome whole = runProgram(RUBBLE_CLI, inFolder(command));
        QVERIFY2(whole.exit == 0, qPrintable(whole.error));
        const FileTree after = withoutIdentities(fileTree(m_folder));
        QVERIFY(after != before);
        for (int call = 1;; ++call) {
            replaceFileTree(m_folder, before);
            const auto [outcome, failed] = runCall(command, call, code, renames);
            if (failed.isEmpty()) {
                QVERIFY(call > 8);
                break;
            }
            const QByteArray where = "call " + QByteArray::number(call) + ", " + failed.toUtf8();
            const FileTree state = withoutIdentities(fileTree(m_folder));
            const bool isKilled = code == 0;
            if (isKilled) {
                const FileTree visible = visibleOf(state);
                const bool isMovedAway = renames == Renames::Plain && packsOf(visible).isEmpty() &&
                                         visible.value(kScene) == before.value(kScene) && state.size() >= before.size();
                QVERIFY2(visible == before || isBeforeIndex(visible, before, after) || isMovedAway, where);
            } else {
                QVERIFY2(outcome.exit == 0 || outcome.exit == 1, where);
                const bool isInPlace = outcome.exit == 0 || outcome.error.contains("cannot be flushed");
                const auto names = [&](const QString& what) { return outcome.error.contains(what); };
                const bool isOfIndex =
                    outcome.exit == 1 && (isInPlace ? names("flush") : names(kIndex) || names(kScene));
                const bool isOfFolder = outcome.exit == 1 && names('"' + m_folder + '"');
                const FileTree visible = visibleOf(state);
                QVERIFY2(visible == (isInPlace ? after : before) ||
                             ((isOfIndex || isOfFolder) && isBeforeIndex(visible, before, after)),
                         where);
                QVERIFY2((outcome.exit == 0) == outcome.error.isEmpty(), where);
                QVERIFY2(outcome.exit == 0 || outcome.error.trimmed().endsWith('.'), where + outcome.error.toUtf8());
                QVERIFY2(!outcome.error.contains(".rubble-"), where + ": " + outcome.error.toUtf8());
            }
            // The next run succeeds where the first left the old state, and leaves nothing else.
            if (visibleOf(state) == after) continue;
            const ProgramOutcome again = runProgram(RUBBLE_CLI, inFolder(command));
            QVERIFY2(again.exit == 0, where + ": " + again.error.toUtf8());
            QVERIFY2(withoutIdentities(fileTree(m_folder)) == after, where);
        }
    }

    /// A new project without an identity, which exports would list.
    static void makeProject(const QString& path) {
        if (!saveProject(path.toStdString(), starterProject())) qFatal("cannot save");
    }

private slots:
    void initTestCase() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("The library with the faults cannot be loaded before that of the sanitizer.");
#endif
        m_folder = QFileInfo(m_place.path()).canonicalFilePath() + "/files";
        m_report = m_place.filePath("report");
    }
    void fileIsOldOrNew_data() {
        QTest::addColumn<int>("code");
        QTest::newRow("full disk") << ENOSPC;
        QTest::newRow("killed") << 0;
        if (qEnvironmentVariableIsSet("RUBBLE_LONG")) QTest::newRow("failing disk") << EIO;
    }
    void fileIsOldOrNew() {
        QFETCH(int, code);
        checkEveryCall({"new", "{folder}/wall.rubble"}, {}, code, Renames::All);
        const FileTree before{{"wall.rubble", bytesOfFile(RUBBLE_SOURCE_DIR "/tests/cli/cases/import-name-taken/before/"
                                                                            "wall.rubble")}};
        checkEveryCall({"import", RUBBLE_SOURCE_DIR "/tests/data/meshes/pair.glb", "--into", "{folder}/wall.rubble"},
                       before, code, Renames::All);
        const QString project = m_place.filePath("recorded.rubble");
        makeProject(project);
        checkEveryCall({"simulate", project, "--steps", "3", "--record", "{folder}/wall.replay"}, {}, code,
                       Renames::All);
    }
    void packIsOldOrNew_data() {
        QTest::addColumn<int>("code");
        QTest::addColumn<bool>("hasFlags");
        QTest::newRow("full disk") << ENOSPC << true;
        QTest::newRow("killed") << 0 << true;
        QTest::newRow("killed without exchange") << 0 << false;
        if (!qEnvironmentVariableIsSet("RUBBLE_LONG")) return;
        QTest::newRow("failing disk") << EIO << true;
        QTest::newRow("full disk without exchange") << ENOSPC << false;
    }
    void packIsOldOrNew() {
        QFETCH(int, code);
        QFETCH(bool, hasFlags);
        const Renames renames = hasFlags ? Renames::All : Renames::Plain;
        const QString project = m_place.filePath("wall.rubble");
        makeProject(project);
        const auto exported = [&](const char* format) {
            return QStringList{"export", project, "--out", "{folder}", "--threads", "1", "--format", format};
        };
        checkEveryCall(exported("obj"), {}, code, renames);
        replaceFileTree(m_folder, {});
        QCOMPARE(runProgram(RUBBLE_CLI, inFolder(exported("glb"))).exit, 0);
        FileTree before = fileTree(m_folder);
        before["wall/wall.glb.import"] = "of an engine";
        checkEveryCall(exported("obj"), before, code, renames);
    }
    /// All calls from one on fail: nothing can be moved back or removed, but the old files are somewhere.
    void nothingIsLostWhereTheDiskIsGone() {
        const QString project = m_place.filePath("gone.rubble");
        makeProject(project);
        const auto exported = [&](const char* format) {
            return QStringList{"export", project, "--out", "{folder}", "--threads", "1", "--format", format};
        };
        replaceFileTree(m_folder, {});
        QCOMPARE(runProgram(RUBBLE_CLI, inFolder(exported("glb"))).exit, 0);
        const FileTree before = fileTree(m_folder);
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("RUBBLE_FAULT_LASTING", "1");
        for (int call = 1;; ++call) {
            replaceFileTree(m_folder, before);
            const Fault fault{.folder = m_folder, .report = m_report, .call = call, .code = EIO};
            const auto [outcome, failed] =
                runWithFault(RUBBLE_CLI, inFolder(exported("obj")), RUBBLE_FAULTS, fault, environment);
            if (failed.isEmpty()) {
                QVERIFY(call > 8);
                break;
            }
            const QByteArray where = "call " + QByteArray::number(call) + ", " + failed.toUtf8();
            QVERIFY2(outcome.exit == 0 || outcome.exit == 1, where);
            QVERIFY2((outcome.exit == 0) == outcome.error.isEmpty(), where + outcome.error.toUtf8());
            // The next run needs no help, and leaves what an undisturbed one does.
            const ProgramOutcome again = runProgram(RUBBLE_CLI, inFolder(exported("obj")));
            QVERIFY2(again.exit == 0, where + ": " + again.error.toUtf8());
            const FileTree after = fileTree(m_folder);
            QVERIFY2(after.contains("wall/wall-fragments.obj") && !after.contains("wall/wall-fragments.glb"), where);
            QVERIFY2(visibleOf(after).size() == after.size(), where + after.keys().join(' ').toUtf8());
        }
    }
    void newFoldersAreFlushed() {
        const QString project = m_place.filePath("deep.rubble");
        makeProject(project);
        replaceFileTree(m_folder, {});
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        const QString log = m_place.filePath("deep-log");
        environment.insert("RUBBLE_FAULT_LOG", log);
        const Fault none{.folder = m_folder, .report = m_report, .call = -1};
        const QStringList command{"export", project, "--out", "{folder}/out/deep", "--threads", "1"};
        QCOMPARE(runWithFault(RUBBLE_CLI, inFolder(command), RUBBLE_FAULTS, none, environment).outcome.exit, 0);
        const QStringList calls = QString::fromUtf8(bytesOfFile(log)).split('\n');
        for (const char* made : {"/out", "/out/deep"}) {
            const QString parent = QFileInfo(m_folder + made).path();
            const qsizetype at = calls.indexOf("mkdir " + m_folder + made);
            QVERIFY2(at >= 0 && calls.indexOf("fsync " + parent, at) > at, qPrintable(calls.join('\n')));
        }
    }
    void packIsFlushedBeforeItGetsItsName_data() {
        QTest::addColumn<bool>("hasFlags");
        QTest::newRow("exchange") << true;
        QTest::newRow("two renames") << false;
    }
    /// After a power cut, of what was not flushed anything may be missing: the calls have to be in this order.
    void packIsFlushedBeforeItGetsItsName() {
        QFETCH(bool, hasFlags);
        const QString project = m_place.filePath("flushed.rubble");
        makeProject(project);
        const QStringList command{"export", project, "--out", "{folder}", "--threads", "1", "--format"};
        replaceFileTree(m_folder, {});
        QCOMPARE(runProgram(RUBBLE_CLI, inFolder(command + QStringList{"glb"})).exit, 0);
        writeFileTree(m_folder, {{"wall/wall.glb.import", "of an engine"}});
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        const QString log = m_place.filePath("log");
        QFile::remove(log);
        environment.insert("RUBBLE_FAULT_LOG", log);
        if (!hasFlags) environment.insert("RUBBLE_FAULT_NO_FLAGS", "1");
        const Fault none{.folder = m_folder, .report = m_report, .call = -1};
        QCOMPARE(runWithFault(RUBBLE_CLI, inFolder(command + QStringList{"obj"}), RUBBLE_FAULTS, none, environment)
                     .outcome.exit,
                 0);
        const QStringList calls = QString::fromUtf8(bytesOfFile(log)).split('\n');
        const auto lastOf = [&](const char* pattern) {
            return calls.lastIndexOf(QRegularExpression(QString(pattern).replace("{folder}", m_folder)));
        };
        const qsizetype kept = lastOf("^link .*/wall.glb.import$");
        const qsizetype contents = lastOf("^fsync .*\\.tmp$");
        const qsizetype named = lastOf(hasFlags ? "^renameat2 .*/wall$" : "^rename .*/wall$");
        const qsizetype parent = lastOf("^fsync {folder}$");
        const qsizetype removed = calls.indexOf(QRegularExpression("^(unlinkat|unlink|remove|rmdir) .*/\\.rubble-.*"));
        QVERIFY2(0 <= kept && kept < contents && contents < named && named < parent && parent < removed,
                 bytesOfFile(log));
    }
};

RUBBLE_TEST_WITH(FaultTest, QCoreApplication)
#include "FaultTest.moc"
