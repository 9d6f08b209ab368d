#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polygon.h"

#include <span>

namespace rubble {

/// The ring without the corners that lie within the tolerance (m) of the straight line between those kept; it begins at
/// the corner farthest from its first one. Empty where less than three are left.
Ring withoutStraightCorners(std::span<const Vec2> ring, double tolerance);

/// The polygon that rings around an area make: the counter-clockwise one is the outline, the clockwise ones are its
/// holes. Without straight corners, from their smallest ones; rings without an area are left out.
///
/// Errors: Degenerate where there is no outline or more than one; those of validated(Polygon).
Result<Polygon> outlineOf(const std::vector<Ring>& rings, double tolerance);

/// The polygon with each ring beginning at its smallest corner (x, then y) and the holes in the order of these, so that
/// the order in which a file names things makes no difference.
Polygon fromSmallestCorners(Polygon polygon);

/// The farthest that a corner of one polygon lies from the boundary of the other, m.
double distanceBetween(const Polygon& a, const Polygon& b);
/// The farthest that a point of the rings lies from the polygon's boundary, m.
double distanceFromBoundary(const Polygon& polygon, const std::vector<Ring>& rings);
/// The distance of a point from the nearest edge, m.
double distanceFromBoundary(const Polygon& polygon, Vec2 point);
/// The distance of a point from an edge, m; off by a few roundings of the longer of its offset and the edge.
double distanceFromEdge(Vec2 point, Vec2 from, Vec2 to);

}  // namespace rubble
