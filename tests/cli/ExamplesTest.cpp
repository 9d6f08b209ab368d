// Tests the examples in docs/examples.
#include "tests/support/TestProgram.h"
#include "tests/support/files/FileBytes.h"
#include "tests/support/files/FileTree.h"

#include <QDateTime>
#include <QDir>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace rubble;

namespace {

const QString kExamples = RUBBLE_SOURCE_DIR "/docs/examples/";

struct ShellRun {
    int exit = -1;
    QString output;  // with errors
};

/// Runs a command line in a folder, with rubble-cli in PATH.
ShellRun inShell(const QString& command, const QString& folder) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("PATH", QFileInfo(RUBBLE_CLI).path() + ':' + environment.value("PATH"));
    environment.insert("LC_ALL", "C");
    environment.remove("MAKEFLAGS");
    QProcess shell;
    shell.setProcessEnvironment(environment);
    shell.setWorkingDirectory(folder);
    shell.setProcessChannelMode(QProcess::MergedChannels);
    shell.start("/bin/sh", {"-ec", command});
    if (!shell.waitForFinished(kPatience)) return {-1, "did not end in time"};
    return {shell.exitCode(), QString::fromUtf8(shell.readAll())};
}

/// Makes a file some hours old.
void age(const QString& path, int hours) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(-3600 * hours), QFileDevice::FileModificationTime));
}

void replaceInFile(const QString& path, const QByteArray& before, const QByteArray& after) {
    QByteArray text = bytesOfFile(path);
    const auto at = text.indexOf(before);
    QVERIFY2(at >= 0, before);
    text.replace(at, before.size(), after);
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
}

/// The commands of a workflow's steps that call rubble-cli.
QStringList commandsOf(const QString& workflow) {
    QStringList commands;
    QRegularExpressionMatchIterator found =
        QRegularExpression("^ +run: (rubble-cli .*)$", QRegularExpression::MultilineOption).globalMatch(workflow);
    while (found.hasNext()) commands.append(found.next().captured(1));
    return commands;
}

}  // namespace

class ExamplesTest : public QObject {
    Q_OBJECT
private slots:
    void makeExportsWhatChanged() {
        const QTemporaryDir place;
        const QString project = place.filePath("house.rubble"), stamp = place.filePath("packs.stamp");
        QVERIFY(QFile::copy(kExamples + "make/Makefile", place.filePath("Makefile")));
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/house.rubble", project));
        age(project, 3);
        const auto make = [&place] { return inShell("make", place.path()); };
        ShellRun run = make();
        QVERIFY2(run.exit == 0, qPrintable(run.output));
        QCOMPARE(QDir(place.filePath("game")).entryList(QDir::Files),
                 (QStringList{"gable.glb", "roof.glb", "wall.glb"}));
        QVERIFY2(make().output.contains("Nothing to be done"), qPrintable(run.output));

        // The project was saved without a change of its assets: no mesh is copied again.
        for (const char* name : {"wall", "gable", "roof"})
            age(place.filePath(QString("packs/%1/manifest.json").arg(name)), 3);
        age(stamp, 2);
        age(project, 1);
        run = make();
        QVERIFY2(run.exit == 0 && run.output.contains("wall: unchanged"), qPrintable(run.output));
        QVERIFY2(!run.output.contains("cp "), qPrintable(run.output));
        QVERIFY(make().output.contains("Nothing to be done"));

        age(stamp, 1);
        for (const char* name : {"wall", "gable", "roof"}) age(place.filePath(QString("game/%1.glb").arg(name)), 2);
        replaceInFile(project, R"("count": 4)", R"("count": 5)");
        run = make();
        QVERIFY2(run.exit == 0 && run.output.contains("wall: 5 fragments"), qPrintable(run.output));
        QCOMPARE(run.output.count("cp "), 1);
        QVERIFY(make().output.contains("Nothing to be done"));

        QCOMPARE(inShell("make clean", place.path()).exit, 0);
        QCOMPARE(QDir(place.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot),
                 (QStringList{"house.rubble", "Makefile"}));
    }
    void workflowPasses() {
        const QTemporaryDir place;
        QVERIFY(QDir(place.path()).mkpath("assets"));
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/house.rubble", place.filePath("assets/house.rubble")));
        const QStringList commands = commandsOf(QString::fromUtf8(bytesOfFile(kExamples + "ci/assets.yml")));
        QCOMPARE(commands.size(), 4);
        for (const QString& command : commands) {
            const ShellRun run = inShell(command, place.path());
            QVERIFY2(run.exit == 0, qPrintable(command + '\n' + run.output));
        }
        for (const char* file : {"check.json", "report.xml", "packs/export.json", "packs/wall/pack.json"})
            QVERIFY2(QFileInfo(place.filePath(file)).size() > 0, file);
    }
    /// Each step ends with 3 where what it looks for is found.
    void workflowStopsAtFindings() {
        const QTemporaryDir place;
        QVERIFY(QDir(place.path()).mkpath("assets"));
        const QString project = place.filePath("assets/house.rubble");
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/house.rubble", project));
        const QStringList commands = commandsOf(QString::fromUtf8(bytesOfFile(kExamples + "ci/assets.yml")));
        replaceInFile(project, R"({"kind": "breaks", "instance": 21, "value": 0})",
                      R"({"kind": "doesNotBreak", "instance": 21, "value": 0})");
        QCOMPARE(inShell(commands[1], place.path()).exit, 3);
        QCOMPARE(inShell(commands[2], place.path()).exit, 0);
        replaceInFile(place.filePath("packs/wall/wall.mtl"), "newmtl", "newmtk");
        QCOMPARE(inShell(commands[3], place.path()).exit, 3);
        QVERIFY(QFile::remove(project));
        QVERIFY(QFile::copy(RUBBLE_SOURCE_DIR "/projects/wall-with-openings.rubble", project));
        QCOMPARE(inShell(commands[0], place.path()).exit, 3);  // slivers
        QVERIFY(QFile::remove(project));
        QCOMPARE(inShell(commands[0], place.path()).exit, 1);
    }
};

RUBBLE_TEST_WITH(ExamplesTest, QCoreApplication)
#include "ExamplesTest.moc"
