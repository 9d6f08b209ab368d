#pragma once

#include "core/geometry/hull/Polytope.h"

#include <optional>
#include <span>

namespace rubble {

/// The polytope of the points that are behind all planes; nothing if a point is not behind each of them, or rounding
/// leaves none. Planes that only touch it are no faces. O(n log n), expected.
/// Source: Preparata, Muller 1979: the hull of the planes' dual points.
std::optional<Polytope> halfSpaceIntersection(std::span<const Plane> planes, Vec3 inside);

}  // namespace rubble
