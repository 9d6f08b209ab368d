#include "viewport/widget/AdaptiveResolution.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMaxRise = 1.1;  // at once: an image that is quick by chance must not make the next one slow
constexpr double kMaxFall = 0.6;
constexpr double kSpare = 0.9;  // of the goal, which is aimed at; between both, the resolution stays

}  // namespace

/// The time is about proportional to the number of pixels.
void AdaptiveResolution::add(double seconds) {
    if (seconds > kSpare * kGoal && seconds <= kGoal) return;
    const double change = std::sqrt(kSpare * kGoal / std::max(seconds, 1e-6));
    m_value = std::clamp(m_value * std::clamp(change, kMaxFall, kMaxRise), kLowest, 1.0);
}

}  // namespace rubble
