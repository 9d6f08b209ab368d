#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rubble {

/// The number of constraints that the solver computes at once. All widths give the same bits: each lane does what the
/// scalar code does.
enum class SimdWidth : std::uint8_t {
    Scalar = 1,
    Four = 4,   // SSE2 on x86-64, NEON on ARM
    Eight = 8,  // AVX2
};

/// The widest that this machine supports; determined once.
SimdWidth widestSimd();
/// The widths that this machine supports, narrowest first.
std::vector<SimdWidth> availableSimdWidths();
std::string_view nameOf(SimdWidth width);

}  // namespace rubble
