#pragma once

#include "core/base/OutOfMemory.h"
#include "core/base/TaskContext.h"

#include <QFutureWatcher>
#include <QPromise>
#include <QThreadPool>

#include <concepts>
#include <functional>
#include <memory>
#include <utility>

namespace rubble {

/// Runs one function at a time on a background thread and delivers its result in the thread of the job, through the
/// event loop.
///
/// start() cancels the running function and discards its result. The destructor cancels and waits.
class BackgroundJob : public QObject {
    Q_OBJECT
public:
    using Call = std::function<void()>;
    /// Queues a call in the thread of the job; it is dropped if the function has been replaced or cancelled by then.
    /// The call must not start another function.
    using Post = std::function<void(Call)>;

    explicit BackgroundJob(QObject* parent = nullptr);
    ~BackgroundJob() override;

    /// A function was started and its result has not been delivered.
    bool isRunning() const { return m_isRunning; }

    /// Starts `work(task)`, or `work(task, post)` if it delivers partial results, on the background thread. isRunning()
    /// is false again when `deliver(result)` is called. Where memory runs out, a Result has the error of outOfMemory();
    /// any other result is not delivered, and `failed` is emitted. A replaced function that ignores task.isCancelled()
    /// delays the next one.
    template <class Work, class Deliver>
    void start(Work work, Deliver deliver) {
        run([work = std::move(work), deliver = std::move(deliver)](const TaskContext& task, const Post& post) -> Call {
            auto evaluate = [&] {
                if constexpr (std::invocable<const Work&, const TaskContext&, const Post&>) {
                    return work(task, post);
                } else {
                    return work(task);
                }
            };
            using Value = decltype(evaluate());
            std::shared_ptr<Value> result;
            if constexpr (std::is_constructible_v<Value, Error>) {
                result = std::make_shared<Value>(orOutOfMemory("working in the background", evaluate));
            } else {
                result = std::make_shared<Value>(evaluate());
            }
            return [deliver, result = std::move(result)] { deliver(std::move(*result)); };
        });
    }

    /// Cancels the running function and discards its result.
    void cancel();
    /// The same, and waits until the function has returned: what it changes outside of it is changed by then, or never.
    void cancelAndWait();

signals:
    /// The fraction of the running function that is done, in [0, 1]; at most about 25 times a second.
    void progressed(double fraction);
    /// Memory ran out, so that there is nothing to deliver; the sentence says so.
    void failed(const QString& sentence);

private:
    void run(std::function<Call(const TaskContext& task, const Post& post)> work);
    void finish();
    void finishPromise(QPromise<Call>& promise);

    QThreadPool m_thread;  // of one thread
    QFutureWatcher<Call> m_watcher;
    CancelToken m_cancel;
    std::shared_ptr<Call> m_delivery;  // written by the thread before its future is finished
    bool m_isRunning = false;
};

}  // namespace rubble
