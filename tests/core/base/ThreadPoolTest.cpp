#include "core/base/ThreadPool.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <new>

#include <sys/resource.h>
#include <unistd.h>

using namespace rubble;

class ThreadPoolTest : public QObject {
    Q_OBJECT
private slots:
    void exceptionsAreThrownOnAfterAllThreadsHaveLeft() {
        for (const int threads : {1, 2, 4}) {
            ThreadPool pool(threads);
            for (const std::size_t failing : {0u, 3u, 6u}) {
                const auto chunk = [&](IndexRange, std::size_t number) {
                    if (number == failing) throw std::bad_alloc();
                };
                QVERIFY_THROWS_EXCEPTION(std::bad_alloc, pool.forEachChunk(97, 7, chunk));
            }
            const auto parts = static_cast<std::size_t>(threads);
            const auto stage = [&](std::size_t number, std::size_t part) {
                if (number == 2 && part + 1 == parts) throw std::bad_alloc();
            };
            QVERIFY_THROWS_EXCEPTION(std::bad_alloc, pool.runStages(5, parts, stage));
            std::atomic<int> calls = 0;
            pool.forEachChunk(97, 7, [&](IndexRange, std::size_t) { ++calls; });
            QCOMPARE(calls.load(), 7);  // it can be used on
        }
    }
    void poolHasTheThreadsThatCouldBeStarted() {
#ifdef __SANITIZE_ADDRESS__
        QSKIP("AddressSanitizer needs all of the address space.");
#endif
        rlimit before{};
        ::getrlimit(RLIMIT_AS, &before);
        std::ifstream statistics("/proc/self/statm");
        std::size_t pages = 0;
        statistics >> pages;
        const rlimit limited{pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + (std::size_t{64} << 20),
                             before.rlim_max};
        ::setrlimit(RLIMIT_AS, &limited);  // room for the stacks of a few threads
        {
            ThreadPool pool(1024);
            ::setrlimit(RLIMIT_AS, &before);
            QVERIFY(pool.size() >= 1 && pool.size() < 1024);
            std::atomic<int> calls = 0;
            pool.forEachChunk(97, 7, [&](IndexRange, std::size_t) { ++calls; });
            QCOMPARE(calls.load(), 7);
        }
    }
    void chunksCoverEveryItemOnce() {
        ThreadPool pool(4);
        for (int round = 0; round < 1000; ++round) {
            std::vector<int> times(97, 0);
            pool.forEachChunk(times.size(), 7, [&](IndexRange range, std::size_t) {
                for (std::size_t i = range.begin; i < range.end; ++i) ++times[i];
            });
            QCOMPARE(std::count(times.begin(), times.end(), 1), std::ptrdiff_t{97});
        }
    }
    void stagesSeeResultsOfEarlierStages_data() {
        QTest::addColumn<int>("threads");
        for (const int threads : {1, 2, 3, 8}) QTest::addRow("%d threads", threads) << threads;
    }
    void stagesSeeResultsOfEarlierStages() {
        QFETCH(int, threads);
        constexpr std::size_t kStages = 40;
        ThreadPool pool(threads);
        const auto parts = static_cast<std::size_t>(threads);
        for (int round = 0; round < 50; ++round) {
            // Each part of a stage sums the results of all parts of the stage before: 1, n, n^2, ... modulo a prime.
            std::vector<std::vector<std::uint64_t>> sums(kStages, std::vector<std::uint64_t>(parts, 1));
            pool.runStages(kStages, parts, [&](std::size_t stage, std::size_t part) {
                if (stage == 0) return;
                std::uint64_t sum = 0;
                for (std::uint64_t before : sums[stage - 1]) sum += before;
                sums[stage][part] = sum % 1000003;
            });
            std::uint64_t expected = 1;
            for (const std::vector<std::uint64_t>& stage : sums) {
                for (std::uint64_t sum : stage) QCOMPARE(sum, expected);
                expected = expected * parts % 1000003;
            }
        }
    }
    void lateWorkersRunNothingTwice() {
        ThreadPool pool(3);
        for (int round = 0; round < 2000; ++round) {
            std::array<std::array<std::atomic<int>, 3>, 2> times{};
            pool.runStages(2, 3, [&](std::size_t stage, std::size_t part) { ++times[stage][part]; });
            for (const auto& stage : times) {
                for (const std::atomic<int>& count : stage) QCOMPARE(count.load(), 1);
            }
        }
    }
};

RUBBLE_TEST(ThreadPoolTest)
#include "ThreadPoolTest.moc"
