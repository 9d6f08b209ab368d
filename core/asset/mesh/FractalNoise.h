#pragma once

#include "core/geometry/predicates/Vec.h"

#include <cstdint>

namespace rubble {

/// Seeded value noise in [-1, 1]: octaves of an interpolated lattice, each with half the amplitude and twice the
/// frequency of the one before. `position` is in cells of the first octave.
double fractalNoise(Vec2 position, std::uint32_t octaves, std::uint64_t randomSeed);

}  // namespace rubble
