#pragma once

#include "core/base/Result.h"

#include <atomic>
#include <functional>
#include <memory>

namespace rubble {

/// Cancels a long function. Copies share one flag: the caller keeps one copy and passes another to the function.
class CancelToken {
public:
    void cancel() const { m_flag->store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return m_flag->load(std::memory_order_relaxed); }

private:
    std::shared_ptr<std::atomic<bool>> m_flag = std::make_shared<std::atomic<bool>>(false);
};

/// Cancellation, progress and the number of threads of a long function. Its result never depends on them.
struct TaskContext {
    CancelToken cancel;
    std::function<void(double fraction)> progress;  // in [0, 1]; may be empty; called on the working thread
    int threads = 1;                                // at least 1

    bool isCancelled() const { return cancel.isCancelled(); }
    void report(double fraction) const {
        if (progress) progress(fraction);
    }
    /// The context of a part of the work, whose progress is mapped to [from, to] of the whole.
    TaskContext stage(double from, double to) const {
        TaskContext part = *this;
        if (progress) {
            part.progress = [whole = progress, from, to](double fraction) { whole(from + (to - from) * fraction); };
        }
        return part;
    }
    /// The error that a cancelled function returns.
    static Error cancelled() { return {ErrorCode::Cancelled, "Cancelled."}; }
};

}  // namespace rubble
