// Tests app/cli/console/Terminal.cpp: cancelling with Ctrl+C.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

#include <csignal>

using namespace rubble;

namespace {

/// A project that takes many seconds.
Project largeProject() {
    Asset asset = assetOf(unitSquare(), 0.5);
    asset.id = 2;
    asset.name = "wall";
    asset.material = 1;
    asset.pattern = scatterOf(2'000'000, 3);
    Project project;
    project.materials = {{.id = 1, .name = "brick"}};
    project.assets = {asset};
    project.nextId = 4;
    return project;
}

}  // namespace

class InterruptTest : public QObject {
    Q_OBJECT
private slots:
    void controlCLeavesNoFiles() {
        QTemporaryDir place;
        const QString project = place.filePath("pipe.rubble");
        QCOMPARE(mkfifo(project.toUtf8().constData(), 0600), 0);
        QProcess program;
        program.start(RUBBLE_CLI, {"export", project, "--out", place.filePath("packs")});
        QFile pipe(project);
        QVERIFY(pipe.open(QIODevice::WriteOnly));  // returns when the program reads it
        pipe.write(QByteArray::fromStdString(projectText(largeProject())));
        pipe.close();
        kill(static_cast<pid_t>(program.processId()), SIGINT);
        QVERIFY(program.waitForFinished(60000));
        QCOMPARE(program.exitStatus(), QProcess::NormalExit);
        QCOMPARE(program.exitCode(), 130);
        QCOMPARE(program.readAllStandardError(), QByteArray("Cancelled.\n"));
        QCOMPARE(program.readAllStandardOutput(), QByteArray());
        QVERIFY(!QFileInfo::exists(place.filePath("packs")));
    }
};

RUBBLE_TEST_WITH(InterruptTest, QCoreApplication)
#include "InterruptTest.moc"
