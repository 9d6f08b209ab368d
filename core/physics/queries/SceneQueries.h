#pragma once

#include "core/base/Result.h"
#include "core/geometry/hull/Polytope.h"
#include "core/physics/state/BodyDefinition.h"

#include <optional>
#include <vector>

namespace rubble {

struct WorldState;

/// The first body that a ray or a moving hull touches.
struct CastHit {
    BodyId body;
    Vec3 point;             // where they touch; the centroid of the contact where edges or faces do
    Vec3 normal;            // outwards from the body, length 1
    double fraction = 0.0;  // of the displacement
};

/// The implementations of World::castRay(), castHull() and overlapping().
std::optional<CastHit> castRay(const WorldState& state, Vec3 from, Vec3 to);
Result<std::optional<CastHit>> castHull(const WorldState& state, const Polytope& polytope, const Pose& pose,
                                        Vec3 displacement);
Result<std::vector<BodyId>> overlappingBodies(const WorldState& state, const Polytope& polytope, const Pose& pose);

}  // namespace rubble
