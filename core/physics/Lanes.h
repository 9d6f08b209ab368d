#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rubble {

/// How many constraints the solver computes at once. All give the same bits: each lane does what the scalar code does.
enum class LaneWidth : std::uint8_t {
    Scalar = 1,
    Four = 4,   // SSE2 on x86-64, NEON on ARM
    Eight = 8,  // AVX2
};

/// The widest that this machine runs; asked once.
LaneWidth widestLanes();
/// Those that this machine runs, narrowest first.
std::vector<LaneWidth> availableLanes();
std::string_view nameOf(LaneWidth width);

}  // namespace rubble
