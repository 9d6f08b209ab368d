#include "editor/document/jobs/BackgroundJob.h"

#include "core/base/HappensBefore.h"
#include "core/base/Parallel.h"
#include "core/base/limits/MemoryReserve.h"
#include "core/base/limits/Threads.h"

#include <QPromise>
#include <QRunnable>

#include <cmath>
#include <memory>
#include <new>
#include <thread>
#include <utility>

namespace rubble {

namespace {

constexpr int kProgressSteps = 1000;
constexpr const char* kDoing = "working in the background";
constexpr char kStarts = 0;  // handed over from the job to its thread

}  // namespace

BackgroundJob::BackgroundJob(QObject* parent) : QObject(parent) {
    m_thread.setMaxThreadCount(1);
    connect(&m_watcher, &QFutureWatcherBase::resultReadyAt, this, [this](int index) {
        receivedFrom(this);
        if (m_isRunning) m_watcher.resultAt(index)();
    });
    connect(&m_watcher, &QFutureWatcherBase::progressValueChanged, this, [this](int value) {
        if (m_isRunning) emit progressed(static_cast<double>(value) / kProgressSteps);
    });
    connect(&m_watcher, &QFutureWatcherBase::finished, this, &BackgroundJob::finish);
}

BackgroundJob::~BackgroundJob() { cancelAndWait(); }

void BackgroundJob::run(std::function<Call(const TaskContext&, const Post&)> work) {
    cancel();
    m_cancel = CancelToken();
    m_delivery = std::make_shared<Call>();
    const auto promise = std::make_shared<QPromise<Call>>();
    promise->setProgressRange(0, kProgressSteps);
    promise->start();
    m_watcher.setFuture(promise->future());  // drops the queued events of the previous function

    TaskContext task{.cancel = m_cancel, .threads = availableProcessors()};
    task.progress = [promise](double fraction) {
        promise->setProgressValue(static_cast<int>(std::lround(kProgressSteps * fraction)));
    };
    QRunnable* runnable =
        QRunnable::create([this, promise, task = std::move(task), work = std::move(work), delivery = m_delivery] {
            receivedFrom(&kStarts);
            const Post post = [&](Call call) {
                handedOver(this);
                promise->addResult(std::move(call));
            };
            const Status ended = orOutOfMemory(kDoing, [&]() -> Status {
                if (!task.isCancelled()) *delivery = work(task, post);
                return success();
            });
            if (!ended) *delivery = [this] { emit failed(QString::fromStdString(outOfMemory(kDoing).message)); };
            handedOver(this);
            finishPromise(*promise);
        });
    handedOver(&kStarts);
    m_isRunning = true;
    try {
        if (m_thread.activeThreadCount() > 0 || canStartThreads(1)) return m_thread.start(runnable);
        const std::unique_ptr<QRunnable> here(runnable);  // the pool would wait forever
        here->run();
    } catch (const std::bad_alloc&) {
        m_isRunning = false;
        throw;
    }
}

/// Makes the job's thread call finish(), even where there is no memory for the event that tells it.
void BackgroundJob::finishPromise(QPromise<Call>& promise) {
    try {
        return promise.finish();
    } catch (const std::bad_alloc&) {
    }
    while (true) {
        releaseMemoryReserve();
        try {
            QMetaObject::invokeMethod(this, &BackgroundJob::finish, Qt::QueuedConnection);
            return;
        } catch (const std::bad_alloc&) {
            std::this_thread::yield();
        }
    }
}

void BackgroundJob::finish() {
    receivedFrom(this);
    if (!m_isRunning) return;
    m_isRunning = false;
    if (const Call deliver = std::exchange(*m_delivery, {})) deliver();
}

void BackgroundJob::cancel() {
    m_cancel.cancel();
    m_isRunning = false;
}

void BackgroundJob::cancelAndWait() {
    cancel();
    m_thread.waitForDone();
    receivedFrom(this);
}

}  // namespace rubble

#include "moc_BackgroundJob.cpp"
