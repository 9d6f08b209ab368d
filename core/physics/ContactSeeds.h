#pragma once

#include "core/physics/Manifold.h"
#include "core/physics/Shape.h"

#include <array>

namespace rubble {

/// How two hulls of pieces of one body touch as long as the pieces have not moved against each other.
struct ContactSeed {
    std::array<std::uint32_t, 2> hulls{};  // of the first shape and the second
    std::array<Look, 2> looks;             // as the first hull sees the second, and the other way round
};

/// The hulls of two shapes that touch or nearly do; the shapes' axes are the same, and the second's centre of mass is `apart`
/// from the first's.
std::vector<ContactSeed> contactSeeds(const Shape& first, const Shape& second, Vec3 apart);

}  // namespace rubble
