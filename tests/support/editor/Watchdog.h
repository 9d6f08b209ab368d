#pragma once

#include "tests/support/ProcessorTime.h"

#include <QTimer>

#include <algorithm>

namespace rubble::test {

/// Measures how long the handlers of events take in the thread that made it: the processor time between two ticks of a
/// timer, which does not depend on other programs as the time on the clock does.
class Watchdog {
public:
    Watchdog() : m_last(processorTime()) {
        QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { check(); });
        m_timer.start(0);
    }
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    /// The longest so far, ms.
    double processorTimeOfAHandler() const { return m_longest; }

private:
    void check() {
        const double now = processorTime();
        m_longest = std::max(m_longest, now - m_last);
        m_last = now;
    }

    QTimer m_timer;
    double m_last;
    double m_longest = 0.0;
};

}  // namespace rubble::test
