#pragma once

#include "core/physics/narrowphase/HullCollision.h"
#include "core/physics/shape/Shape.h"

#include <array>

namespace rubble {

/// The collision of two hulls of sibling fragments that have not moved relative to each other since their parent broke.
struct CachedManifold {
    std::array<std::uint32_t, 2> hulls{};     // of the first shape and the second
    std::array<HullCollision, 2> collisions;  // of the first with the second, and with the hulls swapped
};

/// Collides all pairs of hulls of two shapes with parallel axes, the second's centre of mass at `offset` from the
/// first's. Only pairs with a manifold are returned.
std::vector<CachedManifold> cachedManifolds(const Shape& first, const Shape& second, Vec3 offset);

}  // namespace rubble
