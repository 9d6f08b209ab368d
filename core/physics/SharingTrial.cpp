#include "core/physics/SharingTrial.h"

#include <algorithm>
#include <limits>

namespace rubble {
namespace {

constexpr double kLeastGain = 0.97;  // of the time alone: for less, others may have the processor

}  // namespace

void SharingTrial::note(double milliseconds) {
    const int tried = m_step - m_pause;
    if (tried < 0) {
        m_alone = m_shared = std::numeric_limits<double>::infinity();
    } else if (tried % kTried > 0) {  // the first of each is there to warm up
        double& least = isShared() ? m_shared : m_alone;
        least = std::min(least, milliseconds);
    }
    ++m_step;
    if (tried < 3 * kTried - 1) return;
    m_isWorthIt = m_shared < kLeastGain * m_alone;
    m_step = 0;
    m_pause = std::min(2 * m_pause, kLongestPause);
}

}  // namespace rubble
