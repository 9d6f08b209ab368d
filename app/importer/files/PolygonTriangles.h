#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Triangulates a polygon in space of n >= 3 corners, which may be concave and slightly bent; the triangles' corners
/// are indices of the polygon's and have its orientation. A convex polygon becomes a fan of its first corner. One that
/// crosses itself, or has corners in one place, may be left without ears: what is left then becomes a fan, and may
/// overlap itself. O(n) if it is convex, otherwise O(n²) where ears are found soon, and O(n³) at worst.
///
/// Source: Meisters 1975 (ears); Newell's normal.
std::vector<std::array<std::uint32_t, 3>> polygonTriangles(std::span<const Vec3> corners);

}  // namespace rubble
