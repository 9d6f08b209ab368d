#pragma once

#include "core/base/Result.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstddef>
#include <span>

namespace rubble {

/// Removes the points of a ring that equal the one before, and at its end those that equal the first, as in files that
/// close rings. Returns their numbers in the ring, ascending.
std::vector<std::size_t> removeRepeatedPoints(Ring& ring);

/// Removes the corners of a ring within the tolerance (m) of the line between the remaining ones. Starts at the corner
/// farthest from the first one. Empty if fewer than three remain. O(n) for straight and for polygonal runs; adds the
/// number of visited corners to `visited`.
Ring withoutCollinearCorners(std::span<const Vec2> ring, double tolerance, std::size_t* visited = nullptr);

/// The polygon of boundary rings: the counter-clockwise one is the outline, clockwise ones are holes. Without collinear
/// corners and without rings of zero area; as fromSmallestCorners().
///
/// Errors: Degenerate for no outline or more than one; those of validated(Polygon).
Result<Polygon> outlineOf(const std::vector<Ring>& rings, double tolerance);

/// The polygon with each ring starting at its lexicographically smallest corner and the holes sorted by these:
/// independent of the order in a file.
Polygon fromSmallestCorners(Polygon polygon);

}  // namespace rubble
