#pragma once

#include <chrono>

namespace rubble {

/// Measures wall-clock time.
class Stopwatch {
public:
    /// Milliseconds since the last call, or construction.
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double passed = std::chrono::duration<double, std::milli>(now - m_start).count();
        m_start = now;
        return passed;
    }

private:
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

}  // namespace rubble
