#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace {

const QString kCases = RUBBLE_SOURCE_DIR "/tests/cli/cases";
const bool isUpdating = qEnvironmentVariableIsSet("RUBBLE_UPDATE_CASES");

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Every file below a folder by its path in it.
QMap<QString, QByteArray> treeOf(const QString& folder) {
    QMap<QString, QByteArray> tree;
    QDirIterator files(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString path = files.next();
        tree[QDir(folder).relativeFilePath(path)] = contentOf(path);
    }
    return tree;
}

void writeTree(const QString& folder, const QMap<QString, QByteArray>& tree) {
    for (auto file = tree.begin(); file != tree.end(); ++file) {
        const QString path = folder + '/' + file.key();
        QVERIFY(QDir().mkpath(QFileInfo(path).path()));
        QFile copy(path);
        QVERIFY(copy.open(QIODevice::WriteOnly) && copy.write(file.value()) == file.value().size());
    }
}

/// What a run has to give, or has given.
struct Outcome {
    QByteArray out;
    QByteArray err;
    QByteArray exit;
};

/// Runs the program with one argument a line of `args`, in a folder, on the case's `stdin`.
Outcome run(const QString& folder, const QString& caseFolder) {
    QByteArray lines = contentOf(caseFolder + "/args");
    lines.replace("{source}", RUBBLE_SOURCE_DIR);
    QStringList arguments;
    for (const QByteArray& line : lines.split('\n')) {
        if (!line.isEmpty()) arguments << QString::fromUtf8(line);
    }
    QProcess program;
    program.setWorkingDirectory(folder);
    program.start(RUBBLE_CLI, arguments);
    program.write(contentOf(caseFolder + "/stdin"));
    program.closeWriteChannel();
    if (!program.waitForFinished(60000)) return {{}, "did not end within a minute", "-1"};
    const int exit = program.exitStatus() == QProcess::NormalExit ? program.exitCode() : -1;
    return {program.readAllStandardOutput(), program.readAllStandardError(), QByteArray::number(exit)};
}

}  // namespace

/// Runs rubble-cli as a user does and compares all that it says, and all that it writes, byte for byte.
///
/// A case is a folder: `args` (one a line, {source} stands for the source tree), `stdin`, `stdout`, `stderr` and `exit`;
/// the files in `before/` lie in the folder where it runs, those in `after/` are there when it
/// has run, and no others; without `after/` nothing may have changed. RUBBLE_UPDATE_CASES=1 writes what it sees as what is expected: read the difference before you
/// commit it.
class CasesTest : public QObject {
    Q_OBJECT
private slots:
    void saysAndWrites_data() {
        QTest::addColumn<QString>("folder");
        const QStringList names = QDir(kCases).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
        QVERIFY(!names.isEmpty());
        for (const QString& name : names) QTest::newRow(qPrintable(name)) << kCases + '/' + name;
    }

    void saysAndWrites() {
        QFETCH(QString, folder);
        QTemporaryDir place;
        writeTree(place.path(), treeOf(folder + "/before"));
        const Outcome seen = run(place.path(), folder);
        const QMap<QString, QByteArray> after = treeOf(place.path());

        if (isUpdating) {
            writeTree(folder, {{"stdout", seen.out}, {"stderr", seen.err}, {"exit", seen.exit + '\n'}});
            QDir(folder + "/after").removeRecursively();
            if (after != treeOf(folder + "/before")) writeTree(folder + "/after", after);
        }
        QCOMPARE(QString::fromUtf8(seen.out), QString::fromUtf8(contentOf(folder + "/stdout")));
        QCOMPARE(QString::fromUtf8(seen.err), QString::fromUtf8(contentOf(folder + "/stderr")));
        QCOMPARE(seen.exit, contentOf(folder + "/exit").trimmed());
        const bool isWriting = QFileInfo::exists(folder + "/after");
        const QMap<QString, QByteArray> expected = treeOf(folder + (isWriting ? "/after" : "/before"));
        QCOMPARE(after.keys(), expected.keys());
        for (auto file = expected.begin(); file != expected.end(); ++file) {
            QVERIFY2(after[file.key()] == file.value(), qPrintable(file.key() + " differs"));
        }
    }
};

QTEST_GUILESS_MAIN(CasesTest)
#include "CasesTest.moc"
