#include "core/io/system/ChildProcess.h"
#include "tests/support/TestProgram.h"

#include <QElapsedTimer>
#include <QTest>

#include <chrono>
#include <thread>

using namespace rubble;

namespace {

Result<ChildResult> run(const std::string& script, const ChildLimits& limits = {}, const TaskContext& context = {}) {
    return runChild("/bin/sh", {"-c", script}, limits, context);
}

}  // namespace

class ChildProcessTest : public QObject {
    Q_OBJECT
private slots:
    void outputsAndExitCodeAreReturned() {
        const Result<ChildResult> outcome = run("echo out; echo err >&2; cat; exit 7");
        QVERIFY(outcome->exit == ChildExit::Exited);
        QCOMPARE(outcome->exitCode, 7);
        QCOMPARE(outcome->output, std::string("out\n"));
        QCOMPARE(outcome->error, std::string("err\n"));
    }
    void argumentsArePassedVerbatim() {
        const Result<ChildResult> outcome = runChild("/bin/echo", {"a b", "$HOME", "'"}, {}, {});
        QCOMPARE(outcome->output, std::string("a b $HOME '\n"));
    }
    void largeOutputIsReadCompletely() {
        QCOMPARE(run("head -c 3000000 /dev/zero")->output.size(), std::size_t{3000000});
        QCOMPARE(run("head -c 3000000 /dev/zero >&2")->error.size(), std::size_t{4096});
    }
    void crashIsReported() { QVERIFY(run("kill -SEGV $$")->exit == ChildExit::Crashed); }
    void childIsKilledAtItsTimeLimit() {
        QElapsedTimer timer;
        timer.start();
        QVERIFY(run("sleep 30", {.seconds = 0.2})->exit == ChildExit::TimedOut);
        QVERIFY(run("exec >&- 2>&-; sleep 30", {.seconds = 0.2})->exit != ChildExit::Exited);
        QVERIFY(timer.elapsed() < 5000);
    }
    void childIsKilledAtItsOutputLimit() {
        QVERIFY(run("cat /dev/zero", {.output = 100000})->exit == ChildExit::TooMuchOutput);
    }
    void memoryIsLimited() {
        const Result<ChildResult> outcome = run("ulimit -v; ulimit -t; ulimit -c", {.memory = 1 << 28, .seconds = 3.0});
        QCOMPARE(outcome->output, std::string("262144\n3\n0\n"));
    }
    void missingProgramIsReported() {
        const Result<ChildResult> outcome = runChild("/nowhere/rubble-importer", {}, {}, {});
        QVERIFY(outcome.error().code == ErrorCode::Io);
        QCOMPARE(outcome.error().message,
                 std::string("Cannot start \"/nowhere/rubble-importer\": No such file or directory."));
    }
    void executablesAreFoundInPath() {
        QVERIFY(findExecutable("sh").has_value());
        QVERIFY(!findExecutable("no-such-program"));
        QVERIFY(!findExecutable("."));  // a folder is not executable
    }
    void cancellationKillsTheChild() {
        const TaskContext context;
        std::thread canceller([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            context.cancel.cancel();
        });
        QVERIFY(run("sleep 30", {}, context).error().code == ErrorCode::Cancelled);
        canceller.join();
    }
};

RUBBLE_TEST(ChildProcessTest)
#include "ChildProcessTest.moc"
