#include "core/base/limits/Threads.h"

#include "tests/support/TestProgram.h"

#include <QTest>

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
};

RUBBLE_TEST(ThreadsTest)
#include "ThreadsTest.moc"
