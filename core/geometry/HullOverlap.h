#pragma once

#include "core/geometry/Polytope.h"

#include <optional>

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

/// How far the first can be moved along `way` (of length 1) until it touches the second, m. Negative where it lies in it
/// already, and would have to be moved back so far; nothing where it passes by, or leaves it behind.
///
/// `tolerance`: by how much they may overlap, m, and still pass along each other, as neighbours that touch do.
std::optional<double> distanceAlong(Vec3 way, const Polytope& first, const Pose& firstPose, const Polytope& second,
                                    const Pose& secondPose, double tolerance);

}  // namespace rubble
