#include "core/io/ChildProcess.h"

#include <QElapsedTimer>
#include <QTest>

#include <chrono>
#include <thread>

using namespace rubble;

namespace {

Result<ChildOutcome> run(const std::string& script, const ChildLimits& limits = {}, const TaskContext& context = {}) {
    return runChild("/bin/sh", {"-c", script}, limits, context);
}

}  // namespace

class ChildProcessTest : public QObject {
    Q_OBJECT
private slots:
    void bothOutputsAndTheExitCodeAreGiven() {
        const Result<ChildOutcome> outcome = run("echo out; echo err >&2; cat; exit 7");
        QVERIFY(outcome->end == ChildEnd::Exited);
        QCOMPARE(outcome->exitCode, 7);
        QCOMPARE(outcome->output, std::string("out\n"));
        QCOMPARE(outcome->error, std::string("err\n"));
    }
    void argumentsAreHandedOnAsTheyAre() {
        const Result<ChildOutcome> outcome = runChild("/bin/echo", {"a b", "$HOME", "'"}, {}, {});
        QCOMPARE(outcome->output, std::string("a b $HOME '\n"));
    }
    void muchOutputIsReadWhole() {
        QCOMPARE(run("head -c 3000000 /dev/zero")->output.size(), std::size_t{3000000});
        QCOMPARE(run("head -c 3000000 /dev/zero >&2")->error.size(), std::size_t{4096});
    }
    void aCrashIsTold() { QVERIFY(run("kill -SEGV $$")->end == ChildEnd::Crashed); }
    void whoTakesTooLongIsKilled() {
        QElapsedTimer timer;
        timer.start();
        QVERIFY(run("sleep 30", {.seconds = 0.2})->end == ChildEnd::TimedOut);
        QVERIFY(run("exec >&- 2>&-; sleep 30", {.seconds = 0.2})->end != ChildEnd::Exited);
        QVERIFY(timer.elapsed() < 5000);
    }
    void whoWritesTooMuchIsKilled() {
        QVERIFY(run("cat /dev/zero", {.output = 100000})->end == ChildEnd::TooMuchOutput);
    }
    void memoryIsLimited() {
        const Result<ChildOutcome> outcome =
            run("ulimit -v; ulimit -t; ulimit -c", {.memory = 1 << 28, .seconds = 3.0});
        QCOMPARE(outcome->output, std::string("262144\n3\n0\n"));
    }
    void aProgramThatIsNotThereIsNamed() {
        const Result<ChildOutcome> outcome = runChild("/nowhere/rubble-importer", {}, {}, {});
        QVERIFY(outcome.error().code == ErrorCode::Io);
        QCOMPARE(outcome.error().message,
                 std::string("Cannot start \"/nowhere/rubble-importer\": No such file or directory."));
    }
    void programsAreFoundInPath() {
        QVERIFY(programInPath("sh").has_value());
        QVERIFY(!programInPath("no-such-program"));
        QVERIFY(!programInPath("."));  // a folder is none
    }
    void theCallerCanStopIt() {
        const TaskContext context;
        std::thread canceller([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            context.cancel.cancel();
        });
        QVERIFY(run("sleep 30", {}, context).error().code == ErrorCode::Cancelled);
        canceller.join();
    }
};

QTEST_APPLESS_MAIN(ChildProcessTest)
#include "ChildProcessTest.moc"
