#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Counter-clockwise loops of corner indices. A polygon's corners are numbered through: the outer
/// ring's first, then each hole's.
using IndexLoops = std::vector<std::vector<std::uint32_t>>;

/// Cuts a valid polygon in canonical winding into triangles without new corners: n + 2h - 2 of them for n corners
/// and h holes. Constrained Delaunay, so that slivers are few; every sign exact; O(n log n) but for the flips.
/// Rings may also touch themselves and each other in corners, as those of a planar subdivision's face may; of corners
/// that lie on one point any may then be named.
/// Each triangle starts with its lowest corner; ascending.
///
/// Errors: Crossing where the polygon is not valid, whatever its fault.
Result<IndexLoops> triangles(const Polygon& polygon);

/// Cuts such a polygon into convex parts without new corners: the triangles, joined across every diagonal that is not
/// needed (at most four times the fewest parts possible). A convex polygon is one part, in O(n). Corners on a straight
/// part of a boundary are kept, so that the parts share vertices with their neighbours.
/// Each part starts with its lowest corner; ascending.
///
/// Errors: Crossing where the polygon is not valid, whatever its fault.
/// Source: Hertel, Mehlhorn 1983.
Result<IndexLoops> convexParts(const Polygon& polygon);

}  // namespace rubble
