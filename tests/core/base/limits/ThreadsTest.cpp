#include "core/base/limits/Threads.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <sys/resource.h>

#include <atomic>

using namespace rubble;

class ThreadsTest : public QObject {
    Q_OBJECT
private slots:
    void threadDoesItsWorkBeforeItIsJoined() {
        std::atomic<int> done{0};
        {
            const std::jthread first = startedThread([&] { ++done; });
            const std::jthread second = startedThread([&] { ++done; });
            QVERIFY(first.joinable() && second.joinable());
        }
        QCOMPARE(done.load(), 2);
    }
    void someThreadsCanBeStarted() {
        QVERIFY(canStartThreads(0));
        QVERIFY(canStartThreads(4));
    }
    /// Threads that it starts are slow as well; others stay as they are.
    void priorityIsThatOfTheThreadAndItsOwn() {
        const auto niceness = [] { return getpriority(PRIO_PROCESS, 0); };
        const int before = niceness();
        int lowered = 0, started = 0;
        startedThread([&] {
            lowerThreadPriority();
            lowered = niceness();
            startedThread([&] { started = niceness(); }).join();
        }).join();
        QVERIFY(lowered > before || before >= 5);
        QCOMPARE(started, lowered);
        QCOMPARE(niceness(), before);
    }
};

RUBBLE_TEST(ThreadsTest)
#include "ThreadsTest.moc"
