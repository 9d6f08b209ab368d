// Tests all verbs by recorded runs: app/cli/verbs/*.cpp, app/cli/options/*.cpp, app/cli/output/*.cpp,
// app/cli/simulation/*.cpp, app/cli/console/*.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileTree.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

const QString kCases = RUBBLE_SOURCE_DIR "/tests/cli/cases";
const bool isUpdating = qEnvironmentVariableIsSet("RUBBLE_UPDATE_CASES");

/// The expected or actual result of a run.
struct CaseResult {
    QByteArray out;
    QByteArray err;
    QByteArray exit;
};

/// Runs the program in a folder with the case's `args` and `stdin`.
CaseResult runCase(const QString& folder, const QString& caseFolder) {
    QByteArray lines = bytesOfFile(caseFolder + "/args");
    lines.replace("{source}", RUBBLE_SOURCE_DIR);
    QStringList arguments;
    for (const QByteArray& line : lines.split('\n')) {
        if (!line.isEmpty()) arguments << QString::fromUtf8(line);
    }
    QProcess program;
    program.setWorkingDirectory(folder);
    program.start(RUBBLE_CLI, arguments);
    program.write(bytesOfFile(caseFolder + "/stdin"));
    program.closeWriteChannel();
    if (!program.waitForFinished(kPatience)) return {{}, "did not end in time", "-1"};
    const int exit = program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1;
    return {program.readAllStandardOutput(), program.readAllStandardError(), QByteArray::number(exit)};
}

}  // namespace

/// Runs rubble-cli and compares its outputs, exit status and written files byte for byte.
///
/// A case is a folder with `args` (an argument a line, {source} is the source tree), `stdin`, `stdout`, `stderr` and
/// `exit`. It runs in a folder with the files of `before/`, which afterwards must have exactly those of `after/`, or of
/// `before/` without it. RUBBLE_UPDATE_CASES=1 writes the actual results to the cases: review the difference.
class CasesTest : public QObject {
    Q_OBJECT
private slots:
    void outputAndFilesMatch_data() {
        QTest::addColumn<QString>("folder");
        const QStringList names = QDir(kCases).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
        QVERIFY(!names.isEmpty());
        for (const QString& name : names) QTest::newRow(qPrintable(name)) << kCases + '/' + name;
    }

    void outputAndFilesMatch() {
        QFETCH(QString, folder);
        QTemporaryDir place;
        writeFileTree(place.path(), fileTree(folder + "/before"));
        const CaseResult seen = runCase(place.path(), folder);
        const FileTree after = withoutIdentities(fileTree(place.path()));

        if (isUpdating) {
            writeFileTree(folder, {{"stdout", seen.out}, {"stderr", seen.err}, {"exit", seen.exit + '\n'}});
            QDir(folder + "/after").removeRecursively();
            if (after != fileTree(folder + "/before")) writeFileTree(folder + "/after", after);
        }
        QCOMPARE(QString::fromUtf8(seen.out), QString::fromUtf8(bytesOfFile(folder + "/stdout")));
        QCOMPARE(QString::fromUtf8(seen.err), QString::fromUtf8(bytesOfFile(folder + "/stderr")));
        QCOMPARE(seen.exit, bytesOfFile(folder + "/exit").trimmed());
        const bool isWriting = QFileInfo::exists(folder + "/after");
        const FileTree expected = fileTree(folder + (isWriting ? "/after" : "/before"));
        QCOMPARE(after.keys(), expected.keys());
        for (auto file = expected.begin(); file != expected.end(); ++file) {
            QVERIFY2(after[file.key()] == file.value(), qPrintable(file.key() + " differs"));
        }
    }
};

RUBBLE_TEST_WITH(CasesTest, QCoreApplication)
#include "CasesTest.moc"
