#pragma once

#include "core/geometry/predicates/Vec.h"

#include <vector>

namespace rubble {

/// The largest distance between two points; 0 for fewer than two. O(n log n) in the points, and all pairs of corners of
/// their convex hull, which are few.
/// Source: Andrew 1979, the monotone chain.
double diameterOf(std::vector<Vec2> points);

}  // namespace rubble
