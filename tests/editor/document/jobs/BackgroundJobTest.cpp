#include "editor/document/jobs/BackgroundJob.h"

#include "tests/support/TestProgram.h"

#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThread>

#include <atomic>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <vector>

using namespace rubble;

namespace {

/// Runs until it is cancelled.
int untilCancelled(const TaskContext& task) {
    while (!task.isCancelled()) QThread::yieldCurrentThread();
    return 0;
}

}  // namespace

class BackgroundJobTest : public QObject {
    Q_OBJECT
private slots:
    void outOfMemoryIsAnError() {
        BackgroundJob job;
        std::optional<Result<int>> delivered;
        job.start([](const TaskContext&) -> Result<int> { throw std::bad_alloc(); },
                  [&](Result<int> result) { delivered = std::move(result); });
        QTRY_VERIFY(!job.isRunning());
        QVERIFY(delivered && !*delivered);
        QCOMPARE(delivered->error().code, ErrorCode::Limit);
        QVERIFY(delivered->error().message.starts_with("Out of memory "));
    }
    void runsInTheBackgroundAndDeliversInItsThread() {
        BackgroundJob job;
        const QThread* worker = nullptr;
        const QThread* receiver = nullptr;
        job.start([&worker](const TaskContext&) { return worker = QThread::currentThread(), 42; },
                  [&](int result) {
                      receiver = QThread::currentThread();
                      QCOMPARE(result, 42);
                      QVERIFY(!job.isRunning());
                  });
        QVERIFY(job.isRunning());
        QTRY_VERIFY(!job.isRunning());
        QVERIFY(worker != nullptr && worker != QThread::currentThread());
        QCOMPARE(receiver, QThread::currentThread());
    }
    void cancellingAndWaitingOutlastsTheFunction() {
        BackgroundJob job;
        QSemaphore isStarted;
        std::atomic<bool> isDone = false;
        bool isDelivered = false;
        job.start([&](const TaskContext& task) { return isStarted.release(), untilCancelled(task), isDone = true, 0; },
                  [&](int) { isDelivered = true; });
        isStarted.acquire();
        job.cancelAndWait();
        QVERIFY(!job.isRunning());
        QVERIFY(isDone);
        QCoreApplication::processEvents();
        QVERIFY(!isDelivered);
        job.start([](const TaskContext&) { return 0; }, [&](int) { isDelivered = true; });  // it can be used again
        QTRY_VERIFY(isDelivered);
    }
    void onlyTheNewestResultIsDelivered() {
        BackgroundJob job;
        std::vector<int> results;
        const auto add = [&](int result) { results.push_back(result); };
        job.start(untilCancelled, add);
        for (int k = 1; k <= 3; ++k) job.start([k](const TaskContext&) { return k; }, add);
        QTRY_VERIFY(!job.isRunning());
        QCoreApplication::processEvents();
        QCOMPARE(results, std::vector{3});
    }
    void aResultThatIsQueuedAlreadyIsDroppedWhenReplaced() {
        BackgroundJob job;
        QSemaphore isDone;
        std::vector<int> results;
        const auto add = [&](int result) { results.push_back(result); };
        job.start(
            [&](const TaskContext&, const BackgroundJob::Post& post) {
                post([&results] { results.push_back(0); });
                isDone.release();
                return 1;
            },
            add);
        isDone.acquire();  // the event of its partial result is queued now
        job.start([](const TaskContext&) { return 2; }, add);
        QTRY_VERIFY(!job.isRunning());
        QCOMPARE(results, std::vector{2});
    }
    void nothingIsDeliveredAfterCancel() {
        BackgroundJob job;
        QSignalSpy progress(&job, &BackgroundJob::progressed);
        bool isDelivered = false;
        job.start(
            [&](const TaskContext& task, const BackgroundJob::Post& post) {
                untilCancelled(task);
                task.report(0.5);
                post([&isDelivered] { isDelivered = true; });
                return 0;
            },
            [&isDelivered](int) { isDelivered = true; });
        job.cancel();
        QVERIFY(!job.isRunning());
        bool isNextDelivered = false;  // it runs after the cancelled one, on the same thread
        job.start([](const TaskContext&) { return 1; }, [&isNextDelivered](int) { isNextDelivered = true; });
        QTRY_VERIFY(isNextDelivered);
        QVERIFY(!isDelivered);
        for (const QList<QVariant>& report : progress) QVERIFY(report[0].toDouble() != 0.5);
    }
    void destructionCancelsAndWaits() {
        std::atomic<bool> isReturned = false;
        bool isDelivered = false;
        {
            BackgroundJob job;
            QSemaphore isStarted;
            job.start(
                [&](const TaskContext& task) {
                    isStarted.release();
                    untilCancelled(task);
                    isReturned = true;
                    return 0;
                },
                [&isDelivered](int) { isDelivered = true; });
            isStarted.acquire();
        }
        QVERIFY(isReturned);
        QCoreApplication::processEvents();
        QVERIFY(!isDelivered);
    }
    void partialResultsArriveInOrderBeforeTheLast() {
        BackgroundJob job;
        std::vector<int> results;
        job.start(
            [&results](const TaskContext&, const BackgroundJob::Post& post) {
                for (int k = 0; k < 5; ++k) post([&results, k] { results.push_back(k); });
                return 5;
            },
            [&results](int result) { results.push_back(result); });
        QTRY_VERIFY(!job.isRunning());
        QCOMPARE(results, (std::vector{0, 1, 2, 3, 4, 5}));
    }
    void progressIsDelivered() {
        BackgroundJob job;
        QSignalSpy progress(&job, &BackgroundJob::progressed);
        job.start(
            [](const TaskContext& task) {
                for (int k = 0; k <= 100; ++k) task.report(k / 100.0);
                return 0;
            },
            [](int) {});
        QTRY_VERIFY(!job.isRunning());
        QVERIFY(!progress.isEmpty());
        QCOMPARE(progress.last()[0].toDouble(), 1.0);
    }
    void aResultMayStartTheNextFunction() {
        BackgroundJob job;
        std::vector<int> results;
        std::function<void(int)> deliver = [&](int result) {
            results.push_back(result);
            if (result < 3) job.start([result](const TaskContext&) { return result + 1; }, deliver);
        };
        job.start([](const TaskContext&) { return 1; }, deliver);
        QTRY_COMPARE(results, (std::vector{1, 2, 3}));
        QVERIFY(!job.isRunning());
    }
    void runningOutOfMemoryIsReported() {
        BackgroundJob job;
        const QSignalSpy failed(&job, &BackgroundJob::failed);
        bool isDelivered = false;
        const auto deliver = [&](int) { isDelivered = true; };
        job.start([](const TaskContext&) -> int { throw std::bad_alloc(); }, deliver);
        QTRY_COMPARE(failed.size(), 1);
        QVERIFY(failed[0][0].toString().startsWith("Out of memory while working in the background"));
        job.start([](const TaskContext&) -> int { throw std::length_error("vector"); }, deliver);
        QTRY_COMPARE(failed.size(), 2);
        QVERIFY(!isDelivered && !job.isRunning());
    }
    void resultsNeedNotBeCopyable() {
        BackgroundJob job;
        int value = 0;
        job.start([](const TaskContext&) { return std::make_unique<int>(7); },
                  [&value](std::unique_ptr<int> result) { value = *result; });
        QTRY_COMPARE(value, 7);
    }
};

RUBBLE_TEST_WITH(BackgroundJobTest, QCoreApplication)
#include "BackgroundJobTest.moc"
