#pragma once

#include "core/geometry/Polytope.h"

namespace rubble {

/// How two convex bodies lie to each other.
struct HullOverlap {
    double depth = 0.0;          // m; how far they must be moved apart; negative: the widest gap found along an axis
    Vec3 normal{0.0, 1.0, 0.0};  // from the first to the second, length 1
};

/// The overlap of two polytopes in one frame: the least depth over every face normal of both and every
/// cross product of two edges. No margins, no early outs: the judge of the simulation, not its narrow phase.
HullOverlap hullOverlap(const Polytope& first, const Polytope& second);
/// The same with each placed by a pose.
HullOverlap hullOverlap(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose);

}  // namespace rubble
