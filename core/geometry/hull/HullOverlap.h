#pragma once

#include "core/geometry/hull/Polytope.h"

#include <optional>

namespace rubble {

/// The overlap of two convex bodies.
struct HullOverlap {
    double depth = 0.0;          // m: penetration depth; negative: the largest separation along a tested axis
    Vec3 normal{0.0, 1.0, 0.0};  // from the first to the second, length 1
};

/// The overlap of two polytopes in one frame: the least depth along every face normal of both and every cross product
/// of two edges. Without margins and early outs: a reference for the simulation's narrow phase.
HullOverlap hullOverlap(const Polytope& first, const Polytope& second);
/// The overlap of two polytopes at poses.
HullOverlap hullOverlap(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose);

/// The distance that the first can move along `direction`, of length 1, until it touches the second, m. Negative if
/// they overlap, by the distance to move back; nothing if it misses the second or moves away from it.
///
/// `tolerance`: overlap, m, up to which touching neighbours may slide along each other.
std::optional<double> distanceAlong(Vec3 direction, const Polytope& first, const Pose& firstPose,
                                    const Polytope& second, const Pose& secondPose, double tolerance);

}  // namespace rubble
