// Tests app/cli/console/Terminal.cpp, app/cli/console/FileWatch.cpp: cancelling with Ctrl+C.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/files/RunProgram.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include <csignal>

using namespace rubble;

namespace {

/// A project that takes seconds, and is not refused for its memory.
Project largeProject() {
    Asset asset = assetOf(unitSquare(), 0.5);
    asset.id = 2;
    asset.name = "wall";
    asset.material = 1;
    asset.pattern = scatterOf(400'000, 3);
    Project project;
    project.materials = {{.id = 1, .name = "brick"}};
    project.assets = {asset};
    project.nextId = 4;
    return project;
}

/// Returns whether a process is rubble-cli, not this program before it starts the other, and handles SIGINT itself.
bool catchesInterrupts(qint64 process) {
    const QString folder = "/proc/" + QString::number(process);
    QFile status(folder + "/status");
    if (QFileInfo(folder + "/exe").symLinkTarget() != QFileInfo(RUBBLE_CLI).canonicalFilePath()) return false;
    if (!status.open(QIODevice::ReadOnly)) return false;
    const QByteArray text = status.readAll();
    const QByteArray mask = text.mid(text.indexOf("SigCgt:") + 7, 17).trimmed();
    return (mask.toULongLong(nullptr, 16) >> (SIGINT - 1) & 1) != 0;
}

}  // namespace

class InterruptTest : public QObject {
    Q_OBJECT
private slots:
    /// Each saved change is exported, and what is no project is reported and waited out; Control+C ends it with status
    /// 0.
    void watchExportsAgainUntilControlC() {
        QTemporaryDir place;
        const QString file = place.filePath("wall.rubble"), pack = place.filePath("packs/wall/pack.json");
        Project project = largeProject();
        project.assets[0].pattern = scatterOf(10, 3);
        QVERIFY(saveProject(file.toStdString(), project));
        QProcess program;
        QByteArray out, err;
        program.start(RUBBLE_CLI, {"export", file, "--out", place.filePath("packs"), "--watch"});
        const auto hasReported = [&](const QByteArray& text) {
            out += program.readAllStandardOutput();
            err += program.readAllStandardError();
            return (out + err).contains(text);
        };
        QTRY_VERIFY_WITH_TIMEOUT(hasReported("10 fragments"), kPatience);
        QVERIFY(QFileInfo::exists(pack));
        project.assets[0].pattern = scatterOf(11, 3);
        QVERIFY(saveProject(file.toStdString(), project));
        QTRY_VERIFY_WITH_TIMEOUT(hasReported("11 fragments"), kPatience);
        QFile broken(file);
        QVERIFY(broken.open(QIODevice::WriteOnly) && broken.write("{") == 1);
        broken.close();
        QTRY_VERIFY_WITH_TIMEOUT(hasReported("is not JSON"), kPatience);
        project.assets[0].pattern = scatterOf(12, 3);
        QVERIFY(saveProject(file.toStdString(), project));
        QTRY_VERIFY_WITH_TIMEOUT(hasReported("12 fragments"), kPatience);
        kill(static_cast<pid_t>(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(kPatience));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 0);
    }
    void controlCLeavesNoFiles() {
        QTemporaryDir place;
        const QString project = place.filePath("large.rubble");
        QVERIFY(saveProject(project.toStdString(), largeProject()));
        QProcess program;
        program.start(RUBBLE_CLI, {"export", project, "--out", place.filePath("packs")});
        QTRY_VERIFY_WITH_TIMEOUT(QFileInfo::exists(place.filePath("packs")), kPatience);  // the export has begun
        kill(static_cast<pid_t>(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(kPatience));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 130);
        QCOMPARE(program.readAllStandardError(), QByteArray("Cancelled.\n"));
        QCOMPARE(program.readAllStandardOutput(), QByteArray());
        QVERIFY(!QFileInfo::exists(place.filePath("packs")));
    }
    /// A pipe that nobody writes to is read until the first signal.
    void controlCInterruptsReading_data() {
        QTest::addColumn<QString>("input");
        QTest::newRow("standard input") << "-";
        QTest::newRow("pipe") << "{pipe}";
    }
    void controlCInterruptsReading() {
        QFETCH(QString, input);
        QTemporaryDir place;
        const QString pipe = place.filePath("pipe");
        QCOMPARE(mkfifo(pipe.toUtf8().constData(), 0600), 0);
        QProcess program;
        program.start(RUBBLE_CLI, {"fracture", input.replace("{pipe}", pipe)});
        QTRY_VERIFY_WITH_TIMEOUT(catchesInterrupts(program.processId()), kPatience);
        kill(static_cast<pid_t>(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(kPatience));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 130);
        QCOMPARE(program.readAllStandardError(), QByteArray("Cancelled.\n"));
    }
    void pipeIsNoProject() {
        QTemporaryDir place;
        const QString pipe = place.filePath("pipe.rubble");
        QCOMPARE(mkfifo(pipe.toUtf8().constData(), 0600), 0);
        const ProgramOutcome outcome = runProgram(RUBBLE_CLI, {"check", pipe});
        QCOMPARE(outcome.exit, 1);
        QCOMPARE(outcome.error, "Cannot read \"" + pipe + "\": it is a pipe, not a file.\n");
    }
};

RUBBLE_TEST_WITH(InterruptTest, QCoreApplication)
#include "InterruptTest.moc"
