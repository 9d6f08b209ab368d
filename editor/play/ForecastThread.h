#pragma once

#include "core/play/analysis/Forecast.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace rubble {

/// Computes forecasts on a thread of its own, one at a time, and reports them while they are refined. The order of
/// another throw replaces the running one; one of the same throw, for a scene that has moved, waits for it. Without
/// threads to start there are no forecasts.
class ForecastThread {
public:
    /// Receives a forecast, on the thread.
    using Receiver = std::function<void(const Throw& thrown, std::vector<BodyForecast> bodies)>;

    explicit ForecastThread(Receiver receive) : m_receive(std::move(receive)) {}
    ~ForecastThread();

    void start(std::shared_ptr<const ForecastOrder> order);
    /// Cancels the running order and drops the waiting one.
    void cancel();

private:
    void run();
    void carryOut(const ForecastOrder& order, const CancelToken& cancel) const;

    const Receiver m_receive;
    std::mutex m_mutex;  // guards all below
    std::condition_variable m_wake;
    std::shared_ptr<const ForecastOrder> m_running;
    std::shared_ptr<const ForecastOrder> m_waiting;
    CancelToken m_cancel;  // of m_running
    bool m_isQuitting = false;
    std::jthread m_thread;  // started with the first order
};

}  // namespace rubble
