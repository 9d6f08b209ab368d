#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// The angular momentum of a body about its centre, in world axes: the stored one plus the changes of angular velocity
/// since.
Vec3f angularMomentum(const WorldState& state, std::uint32_t body);
/// Whether a body rotates so fast that its world inertia changes noticeably within a step of dt seconds; for bodies
/// without contacts, whether it rotates at all.
bool isFastRotating(const WorldState& state, std::uint32_t body, float dt);
/// The rotation of such a body since the beginning of the step, advanced by h seconds. Conserves angular momentum
/// exactly, and energy does not drift, since the step is time-reversible.
/// Source: Hairer, Lubich, Wanner 2006, "Geometric numerical integration", VII.5 (midpoint rule).
Quatf midpointRotation(const WorldState& state, std::uint32_t body, float h);
/// Applies the rotation of a step to the pose: updates the world inertia, and the angular velocity so that angular
/// momentum is conserved.
void applyRotation(WorldState& state, std::uint32_t body);

}  // namespace rubble
