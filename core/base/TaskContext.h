#pragma once

#include "core/base/Result.h"

#include <atomic>
#include <functional>
#include <memory>

namespace rubble {

/// Asks long functions to stop. Copies share one flag, so that a window or a signal handler can
/// keep one copy and hand the other to the work.
class CancelToken {
public:
    void cancel() const { m_flag->store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return m_flag->load(std::memory_order_relaxed); }

private:
    std::shared_ptr<std::atomic<bool>> m_flag = std::make_shared<std::atomic<bool>>(false);
};

/// What every long function is given: when to stop, whom to tell how far it is, and how many
/// threads it may use. The results never depend on it.
struct TaskContext {
    CancelToken cancel;
    std::function<void(double fraction)> progress;  // in [0, 1], may be empty; called from the work's thread
    int threads = 1;                                // at least 1

    bool isCancelled() const { return cancel.isCancelled(); }
    void report(double fraction) const {
        if (progress) progress(fraction);
    }
    /// The same for a part of the work, whose progress is told between two fractions of the whole.
    TaskContext stage(double from, double to) const {
        TaskContext part = *this;
        if (progress) {
            part.progress = [whole = progress, from, to](double fraction) { whole(from + (to - from) * fraction); };
        }
        return part;
    }
    /// The fault that a function returns when it was asked to stop.
    static Error cancelled() { return {ErrorCode::Cancelled, "Cancelled."}; }
};

}  // namespace rubble
