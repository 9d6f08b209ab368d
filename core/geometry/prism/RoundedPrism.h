#pragma once

#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/polygon/Polygon.h"

#include <vector>

namespace rubble {

// Parts of fitPrism() for meshes whose points are rounded, so that no cap is flat and no side is straight.

/// The axis near a given one, of length 1, along which the faces of a solid mesh deviate least from flat caps and
/// straight sides: the least squares of the heights of cap points over their means and of the projected widths of
/// sides. A face belongs to the caps if it is closer to perpendicular than to parallel. O(n).
Vec3 axisOfLeastSquares(const TriangleMesh& mesh, Vec3 axis, double rounding);

/// Rings halfway between those of the two caps: each point of `top` is moved half the way to the nearest point of
/// `bottom` within `radius`, m; points without one stay. Both wind the same way. O(n log n) for points farther apart.
std::vector<Ring> ringsBetween(std::vector<Ring> top, const std::vector<Ring>& bottom, double radius);

}  // namespace rubble
