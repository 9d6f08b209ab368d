#include "core/physics/world/ThreadingHeuristic.h"

#include <algorithm>
#include <limits>

namespace rubble {
namespace {

constexpr double kMaxRatio = 0.97;  // of the time on one thread; a smaller gain is not worth the extra cores

}  // namespace

void ThreadingHeuristic::addStep(double milliseconds) {
    const int trialStep = m_step - m_pause;
    if (trialStep < 0) {
        m_single = m_threaded = std::numeric_limits<double>::infinity();
    } else if (trialStep % kTrialSteps > 0) {  // the first step of each kind warms up the caches
        double& least = isThreaded() ? m_threaded : m_single;
        least = std::min(least, milliseconds);
    }
    ++m_step;
    if (trialStep < 3 * kTrialSteps - 1) return;
    m_isFaster = m_threaded < kMaxRatio * m_single;
    m_step = 0;
    m_pause = std::min(2 * m_pause, kMaxPause);
}

}  // namespace rubble
