#pragma once

#include "core/geometry/predicates/Vec.h"

#include <vector>

namespace rubble {

/// Some of the points of a line, at least one, the first and the last among them, such that all others are within
/// `tolerance` of the line through those that stay. Equal points that follow each other become one.
/// Source: Ramer 1972; Douglas, Peucker 1973.
std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance);

}  // namespace rubble
