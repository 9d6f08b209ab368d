#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Triangulates a polygon in space of n >= 3 corners, which may be concave and slightly bent; the triangles' corners
/// are indices of the polygon's and have its orientation. A polygon that is convex, or crosses itself, becomes a fan.
/// O(n) if it is convex, otherwise O(n^2) expected.
///
/// Source: Meisters 1975 (ears); Newell's normal.
std::vector<std::array<std::uint32_t, 3>> polygonTriangles(std::span<const Vec3> corners);

}  // namespace rubble
