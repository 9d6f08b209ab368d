#pragma once

#include <QTimer>

#include <time.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

namespace rubble::test {

/// Measures how late the event loop of the thread that made it handles events: a timer that is due every few
/// milliseconds is as late as the handler before it is long.
///
/// On a busy machine every thread is late. So a thread that only sleeps is measured as well, for comparison, and the
/// processor time between two events, which does not depend on other programs.
class Watchdog {
public:
    Watchdog() {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(kInterval);
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { check(); });
        m_timer.start();
        m_last = Clock::now();
        m_lastProcessor = processorTime();
        m_control = std::thread([this] { runControl(); });
    }
    ~Watchdog() {
        m_isOver = true;
        m_control.join();
    }
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// The worst so far, ms.
    double lateness() const { return m_lateness; }
    double processorTimeOfAHandler() const { return m_processor; }
    double latenessOfControl() const { return m_controlLateness; }
    /// Whether no event was handled later than a limit, as far as the machine let any thread do so.
    bool isInTime(double limit = 50.0) const {
        return m_processor <= limit && m_lateness <= limit + 3.0 * m_controlLateness;
    }
    /// The processor time of the calling thread, ms.
    static double processorTime() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds kInterval{5};

    static double milliseconds(Clock::duration time) { return std::chrono::duration<double, std::milli>(time).count(); }
    void check() {
        const Clock::time_point now = Clock::now();
        const double processor = processorTime();
        m_lateness = std::max(m_lateness, milliseconds(now - m_last - kInterval));
        m_processor = std::max(m_processor, processor - m_lastProcessor);
        m_last = now;
        m_lastProcessor = processor;
    }
    void runControl() {
        while (!m_isOver) {
            const Clock::time_point due = Clock::now() + kInterval;
            std::this_thread::sleep_until(due);
            m_controlLateness = std::max(m_controlLateness.load(), milliseconds(Clock::now() - due));
        }
    }

    QTimer m_timer;
    Clock::time_point m_last;
    double m_lastProcessor = 0.0;  // this and the following: ms
    double m_lateness = 0.0;
    double m_processor = 0.0;
    std::atomic<double> m_controlLateness{0.0};
    std::atomic<bool> m_isOver{false};
    std::thread m_control;
};

}  // namespace rubble::test
