#pragma once

#include "core/geometry/Vec.h"

#include <cstdint>

namespace rubble {

/// Value noise in [-1, 1], seeded: octaves of a smoothed lattice, each half as high and twice as fine as the one before.
/// `place` is in bumps of the first octave.
double fractalNoise(Vec2 place, std::uint32_t octaves, std::uint64_t randomSeed);

}  // namespace rubble
