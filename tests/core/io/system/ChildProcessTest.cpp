#include "core/io/system/ChildProcess.h"
#include "tests/support/ProcessorTime.h"
#include "tests/support/TestProgram.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

using namespace rubble;

namespace {

/// Cancels a task once a file is there, which the child makes.
std::thread cancellerAt(const QString& path, const TaskContext& context) {
    return std::thread([path, &context] {
        while (!QFile::exists(path)) std::this_thread::yield();
        context.cancel.cancel();
    });
}

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
        QCOMPARE(run("head -c 3000000 /dev/zero >&2", {.error = 1000000})->error.size(), std::size_t{1000000});
    }
    void crashIsReported() {
        const Result<ChildResult> outcome = run("kill -SEGV $$");
        QVERIFY(outcome->exit == ChildExit::Crashed);
        QCOMPARE(outcome->signal, SIGSEGV);
    }
    void childIsKilledAtItsTimeLimit() {
        // A child that is not killed would keep the test from ending.
        QVERIFY(run("exec sleep 10000", {.seconds = 0.2})->exit == ChildExit::TimedOut);
        QVERIFY(run("exec >&- 2>&- sleep 10000", {.seconds = 0.2})->exit == ChildExit::TimedOut);
    }
    /// Also of a child that is busy, ignores signals, writes without end or is stopped. The limit of its processor time
    /// is a whole second, which comes later.
    void timeLimitIsThatOfTheClock_data() {
        QTest::addColumn<std::string>("script");
        QTest::newRow("busy") << std::string("while :; do :; done");
        QTest::newRow("ignores signals") << std::string("trap '' TERM INT HUP XCPU; while :; do :; done");
        QTest::newRow("writes") << std::string("while :; do echo line; done");
        QTest::newRow("stopped") << std::string("kill -STOP $$");
    }
    void timeLimitIsThatOfTheClock() {
        QFETCH(const std::string, script);
        const double start = test::processorTime();
        QElapsedTimer clock;
        clock.start();
        const Result<ChildResult> outcome = run(script, {.seconds = 0.5});
        QVERIFY(outcome->exit == ChildExit::TimedOut);
        QVERIFY(clock.hasExpired(499));
        QVERIFY(test::processorTime() - start < 500.0);  // it waits for the child, without being busy itself
    }
    void processorTimeIsLimited() {
        QCOMPARE(run("ulimit -St; ulimit -Ht", {.seconds = 3.0})->output, std::string("3\n4\n"));
        QVERIFY(run("ulimit -St 1; while :; do :; done", {.seconds = 60.0})->exit == ChildExit::TimedOut);
        QVERIFY(run("kill -KILL $$")->exit == ChildExit::Crashed);
    }
    void childMayCloseItsStreamsBeforeItEnds() {
        const Result<ChildResult> outcome = run("exec >&- 2>&-; sleep 0.2; exit 7");
        QVERIFY(outcome->exit == ChildExit::Exited);
        QCOMPARE(outcome->exitCode, 7);
    }
    void childIsKilledAtItsOutputLimit() {
        QVERIFY(run("cat /dev/zero", {.output = 100000})->exit == ChildExit::TooMuchOutput);
    }
    void memoryIsLimited() {
        const Result<ChildResult> outcome = run("ulimit -v; ulimit -t; ulimit -c", {.memory = 1 << 28, .seconds = 3.0});
        QCOMPARE(outcome->output, std::string("262144\n3\n0\n"));
    }
    void writtenFilesAndDescriptorsAreLimited() {
        const Result<ChildResult> outcome = run("ulimit -f; ulimit -n", {.fileSize = 0, .descriptors = 32});
        QCOMPARE(outcome->output, std::string("0\n32\n"));
    }
    void environmentCanBeEmpty() {
        qputenv("RUBBLE_TEST_VARIABLE", "visible");
        const auto variable = [](ChildEnvironment environment) {
            return run("echo \"$RUBBLE_TEST_VARIABLE\"", {.environment = environment})->output;
        };
        QCOMPARE(variable(ChildEnvironment::Inherited), std::string("visible\n"));
        QCOMPARE(variable(ChildEnvironment::Empty), std::string("\n"));
        qunsetenv("RUBBLE_TEST_VARIABLE");
    }
    void otherDescriptorsAreClosed() {
        if (!std::filesystem::exists("/proc/self/fd")) QSKIP("/proc is not mounted.");
        const int inherited = ::open("/dev/null", O_RDONLY);  // without O_CLOEXEC
        const Result<ChildResult> outcome = run("ls /proc/self/fd");
        ::close(inherited);
        QCOMPARE(outcome->output, std::string("0\n1\n2\n3\n"));  // ls itself opens 3
    }
    void privilegesCannotBeGained() {
        if (!std::filesystem::exists("/proc/self/status")) QSKIP("/proc is not mounted.");
        QCOMPARE(run("grep NoNewPrivs /proc/self/status")->output, std::string("NoNewPrivs:\t1\n"));
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
        const QTemporaryDir folder;
        const QString started = folder.filePath("started");
        const TaskContext context;
        std::thread canceller = cancellerAt(started, context);
        const std::string script = "touch '" + started.toStdString() + "'; exec sleep 10000";
        QVERIFY(run(script, {}, context).error().code == ErrorCode::Cancelled);
        canceller.join();
    }
    void childThatClosedItsStreamsIsCancelled() {
        const QTemporaryDir folder;
        const QString started = folder.filePath("started");
        const TaskContext context;
        std::thread canceller = cancellerAt(started, context);
        const std::string script = "exec >&- 2>&-; touch '" + started.toStdString() + "'; exec sleep 10000";
        QVERIFY(run(script, {}, context).error().code == ErrorCode::Cancelled);
        canceller.join();
    }
    void closedStandardStreamsDoNoHarm() {
        const pid_t child = ::fork();
        if (child == 0) {
            ::close(STDIN_FILENO);
            ::close(STDOUT_FILENO);
            const Result<ChildResult> outcome = run("cat; echo out; echo err >&2");
            const Result<ChildResult> missing = runChild("/nowhere", {}, {}, {});
            ::_exit(outcome && outcome->output == "out\n" && outcome->error == "err\n" && !missing ? 0 : 1);
        }
        int status = -1;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QVERIFY(WIFEXITED(status));
        QCOMPARE(WEXITSTATUS(status), 0);
    }
    void closedStandardStreamsAreTaken() {
        const pid_t child = ::fork();
        if (child == 0) {
            for (int stream = 0; stream < 3; ++stream) ::close(stream);
            occupyStandardStreams();
            const int next = ::open("/dev/null", O_RDONLY);
            const bool areSilent = ::write(STDOUT_FILENO, "x", 1) < 0 && ::write(STDERR_FILENO, "x", 1) < 0;
            ::_exit(next > STDERR_FILENO && areSilent ? 0 : 1);
        }
        int status = -1;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
    }
};

RUBBLE_TEST(ChildProcessTest)
#include "ChildProcessTest.moc"
