#pragma once

#include "core/geometry/Polygon.h"

namespace rubble {

/// How long the cut is that a straight line through a point makes in a polygon: all its parts together, whatever way the rings run. A
/// line along an edge counts as one just beside it. `direction` is of length 1. O(n log n).
double cutLength(const Polygon& polygon, Vec2 through, Vec2 direction);

/// The shortest cut through the centre of area of a polygon, of 180 lines a degree apart: at most 0.004 % longer than the
/// shortest of a strip. Such a line has area on both sides, so that the cut is never nothing and always takes the polygon apart.
double shortestCentreCut(const Polygon& polygon);

}  // namespace rubble
