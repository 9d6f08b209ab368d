#include "core/sound/mix/Limiter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>

namespace rubble {
namespace {

constexpr std::int64_t kWindow = 480;  // samples to each side: 10 ms

/// The least gain within the window around each sample.
std::vector<double> leastAround(const std::vector<double>& gains) {
    const auto count = static_cast<std::int64_t>(gains.size());
    std::vector<double> least(gains.size());
    std::deque<std::int64_t> candidates;  // ascending gains
    for (std::int64_t k = 0; k < count + kWindow; ++k) {
        if (k < count) {
            while (!candidates.empty() && gains[candidates.back()] >= gains[k]) candidates.pop_back();
            candidates.push_back(k);
        }
        const std::int64_t at = k - kWindow;
        if (at < 0) continue;
        while (candidates.front() < at - kWindow) candidates.pop_front();
        least[at] = gains[candidates.front()];
    }
    return least;
}

}  // namespace

void limit(StereoSamples& samples) {
    std::vector<double> gains(samples.size());
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const double peak = std::max(std::abs(samples[k][0]), std::abs(samples[k][1]));
        gains[k] = peak > kCeiling ? kCeiling / peak : 1.0;
    }
    const std::vector<double> least = leastAround(gains);
    // The mean of what is at most the gain of a sample at every place of the window is at most that gain.
    const auto count = static_cast<std::int64_t>(samples.size());
    double missing = 0.0;  // sum of 1 - least in the window: exactly 0 where nothing is turned down
    std::int64_t turnedDown = 0;
    for (std::int64_t k = -kWindow; k < count; ++k) {
        const std::int64_t enters = k + kWindow, leaves = k - kWindow - 1;
        if (enters < count && least[enters] < 1.0) missing += 1.0 - least[enters], ++turnedDown;
        if (leaves >= 0 && least[leaves] < 1.0) missing -= 1.0 - least[leaves], --turnedDown;
        if (turnedDown == 0) missing = 0.0;
        if (k < 0 || turnedDown == 0) continue;
        const double places =
            static_cast<double>(std::min(k + kWindow, count - 1) - std::max<std::int64_t>(k - kWindow, 0) + 1);
        const auto gain = static_cast<float>(1.0 - missing / places);
        samples[k][0] *= gain;
        samples[k][1] *= gain;
    }
}

}  // namespace rubble
