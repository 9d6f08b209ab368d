#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Counter-clockwise loops of corner indices. A polygon's corners are numbered through: the outer
/// ring's first, then each hole's.
using IndexLoops = std::vector<std::vector<std::uint32_t>>;

/// Cuts a valid polygon into triangles without new corners: n + 2h - 2 of them for n corners and h holes
/// (fewer where corners lie on a line). Constrained Delaunay, so that slivers are few; every sign exact.
///
/// Errors: Crossing where the polygon is not valid.
Result<IndexLoops> triangles(const Polygon& polygon);

/// Cuts a valid polygon into convex parts without new corners: the triangles, joined across every
/// diagonal that is not needed (at most four times the fewest possible). A convex polygon is one part.
/// Corners on a straight part of a boundary are kept, so that the parts share vertices with their neighbours.
///
/// Errors: Crossing where the polygon is not valid.
/// Source: Hertel, Mehlhorn 1983.
Result<IndexLoops> convexParts(const Polygon& polygon);

}  // namespace rubble
