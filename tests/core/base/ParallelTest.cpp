#include "core/base/Parallel.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <new>
#include <thread>
#include <vector>

using namespace rubble;

class ParallelTest : public QObject {
    Q_OBJECT
private slots:
    void everyIndexIsVisitedOnceForAnyThreadCount() {
        for (const int threads : {-1, 0, 1, 2, 7, 100}) {
            std::vector<int> calls(50, 0);
            forEachIndex(calls.size(), threads, [&](std::size_t index) { ++calls[index]; });
            QCOMPARE(calls, std::vector<int>(50, 1));
        }
    }
    void zeroIndicesCallNothing() {
        forEachIndex(0, 4, [](std::size_t) { QFAIL("called without an index"); });
    }
    void loopsWithinLoopsEnd() {
        std::vector<std::vector<int>> calls(20, std::vector<int>(30, 0));
        forEachIndex(calls.size(), 4, [&](std::size_t row) {
            forEachIndex(calls[row].size(), 4, [&](std::size_t column) { ++calls[row][column]; });
        });
        QCOMPARE(calls, std::vector(20, std::vector<int>(30, 1)));
    }
    void loopsOfSeveralThreadsEnd() {
        std::atomic<int> calls{0};
        std::vector<std::jthread> threads;
        for (int k = 0; k < 6; ++k) {
            threads.emplace_back([&] {
                for (int round = 0; round < 200; ++round) forEachIndex(9, 3, [&](std::size_t) { ++calls; });
            });
        }
        threads.clear();
        QCOMPARE(calls.load(), 6 * 200 * 9);
    }
    void exceptionsAreThrownOnOnceAllThreadsHaveLeft() {
        for (int round = 0; round < 100; ++round) {
            std::atomic<int> inside{0};
            const auto work = [&](std::size_t index) {
                ++inside;
                if (index == 5) {
                    --inside;
                    throw std::bad_alloc();
                }
                --inside;
            };
            QVERIFY_THROWS_EXCEPTION(std::bad_alloc, forEachIndex(40, 4, work));
            QCOMPARE(inside.load(), 0);
        }
    }
    void aForkedProcessHasNoHelpersAndNeedsNone() {
        std::atomic<int> calls{0};
        const auto work = [&](std::size_t) { ++calls; };
        forEachIndex(50, 4, work);
        const pid_t child = ::fork();
        if (child == 0) {
            calls = 0;
            forEachIndex(50, 4, work);
            ::_exit(calls == 50 ? 0 : 1);
        }
        int status = -1;
        ::waitpid(child, &status, 0);
        QVERIFY(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    }
};

RUBBLE_TEST(ParallelTest)
#include "ParallelTest.moc"
