#pragma once

#include "core/geometry/hull/Polytope.h"

#include <vector>

namespace rubble {

/// Cuts the hulls of different fragments apart where they overlap by more than `tolerance` metres, each pair at the
/// plane halfway through its overlap, in the direction in which that is least: hulls of fragments of one cell, and of
/// merged cells, which are not convex, reach into each other. Where nothing would be left of one of them, it stays and
/// the other is cut. What remains has at most kMaxCollisionCorners corners, or as many as before. Returns the deepest
/// overlap that was cut from each fragment, m. O(n log n) for hulls that touch few others.
std::vector<double> separateHulls(std::vector<std::vector<Polytope>>& hullsOfFragments, double tolerance);

}  // namespace rubble
