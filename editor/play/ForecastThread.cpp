#include "editor/play/ForecastThread.h"

#include "core/base/OutOfMemory.h"
#include "core/base/limits/Threads.h"

#include <utility>

namespace rubble {

ForecastThread::~ForecastThread() {
    {
        const std::lock_guard lock(m_mutex);
        m_isQuitting = true;
        m_cancel.cancel();
    }
    m_wake.notify_all();
    if (m_thread.joinable()) m_thread.join();  // it uses the other members
}

void ForecastThread::start(std::shared_ptr<const ForecastOrder> order) {
    const std::lock_guard lock(m_mutex);
    if (!m_thread.joinable()) m_thread = startedThread([this] { run(); });
    if (m_running && m_running->thrown != order->thrown) m_cancel.cancel();
    m_waiting = std::move(order);
    m_wake.notify_all();
}

void ForecastThread::cancel() {
    const std::lock_guard lock(m_mutex);
    m_cancel.cancel();
    m_waiting.reset();
}

void ForecastThread::run() {
    std::unique_lock lock(m_mutex);
    while (true) {
        m_wake.wait(lock, [this] { return m_waiting || m_isQuitting; });
        if (m_isQuitting) return;
        const auto order = m_running = std::exchange(m_waiting, nullptr);
        const CancelToken cancel = m_cancel = CancelToken();
        lock.unlock();
        carryOut(*order, cancel);
        lock.lock();
        m_running.reset();
    }
}

/// Reports what has changed, at least once. Where memory runs out there is no forecast.
void ForecastThread::carryOut(const ForecastOrder& order, const CancelToken& cancel) const {
    std::optional<std::vector<BodyForecast>> known;
    const auto refine = [&](const std::vector<BodyForecast>& bodies) {
        if (cancel.isCancelled() || known == bodies) return;
        known = bodies;
        m_receive(order.thrown, bodies);
    };
    (void)orOutOfMemory("forecasting", [&]() -> Status {
        const Result<std::vector<BodyForecast>> bodies = breakForecast(order, {.cancel = cancel}, refine);
        if (bodies) refine(*bodies);
        return success();
    });
}

}  // namespace rubble
