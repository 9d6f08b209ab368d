#pragma once

#include "core/base/Result.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Counter-clockwise loops of corner indices, as in IndexedCorners: the outer ring's corners first, then each hole's.
using IndexLoops = std::vector<std::vector<std::uint32_t>>;

/// The constrained Delaunay triangulation of a valid polygon in canonical winding, without new vertices: n + 2h - 2
/// triangles for n corners and h holes. By exact predicates; O(n log n) plus the edge flips. Rings may touch themselves
/// and each other in corners, like those of a face of a planar subdivision; any of several corners at one point may
/// then be used. Each triangle starts with its lowest index; sorted.
///
/// Errors: Crossing for an invalid polygon of any kind.
Result<IndexLoops> triangles(const Polygon& polygon);

/// Decomposes such a polygon into convex parts without new vertices, by merging triangles across inessential diagonals:
/// at most four times the minimum number of parts. A convex polygon is one part, in O(n). Collinear corners are kept,
/// so that neighbouring parts share vertices. Each part starts with its lowest index; sorted.
///
/// Errors: Crossing for an invalid polygon of any kind.
/// Source: Hertel, Mehlhorn 1983.
Result<IndexLoops> convexParts(const Polygon& polygon);

}  // namespace rubble
