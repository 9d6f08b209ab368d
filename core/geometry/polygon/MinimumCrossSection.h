#pragma once

#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// The total length of the intersection of a polygon with a line, for any winding. A line along an edge counts as one
/// just beside it. `direction` has length 1. O(n log n).
double crossSectionLength(const Polygon& polygon, Vec2 through, Vec2 direction);

/// The shortest cross-section through the centroid of a polygon, of 180 lines one degree apart: for a strip, at most
/// 0.004 % longer than the minimum. A line through the centroid has area on both sides, so that the cross-section
/// separates the polygon.
double minimumCrossSection(const Polygon& polygon);

}  // namespace rubble
