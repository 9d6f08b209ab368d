#include "viewport/widget/AdaptiveQuality.h"

#include "viewport/render/Renderer.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMaxRise = 1.1;  // at once: a picture that is quick by chance must not make the next one slow
constexpr double kMaxFall = 0.6;
constexpr double kSpare = 0.9;        // of the goal, which is aimed at; between both, the quality stays
constexpr double kDetailPower = 2.2;  // at the lowest resolution, fragments of less than 25 pixels are not drawn apart

}  // namespace

double AdaptiveQuality::minFragmentPixels() const { return kMinFragmentPixels * std::pow(m_resolution, -kDetailPower); }

/// The time is about proportional to the number of pixels.
void AdaptiveQuality::add(double seconds) {
    if (seconds > kSpare * kGoal && seconds <= kGoal) return;
    const double change = std::sqrt(kSpare * kGoal / std::max(seconds, 1e-6));
    m_resolution = std::clamp(m_resolution * std::clamp(change, kMaxFall, kMaxRise), kLowest, 1.0);
}

}  // namespace rubble
