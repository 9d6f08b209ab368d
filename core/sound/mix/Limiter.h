#pragma once

#include <array>
#include <vector>

namespace rubble {

/// Stereo samples of any amplitude.
using StereoSamples = std::vector<std::array<float, 2>>;

inline constexpr double kCeiling = 0.97;  // of full scale

/// Scales samples so that none exceeds kCeiling: where some do, all within 10 ms are turned down smoothly, both sides
/// alike. Others are left as they are. O(n).
void limit(StereoSamples& samples);

}  // namespace rubble
