#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// The angular momentum of a body about its centre, in world axes, between two steps.
Vec3f angularMomentum(const WorldState& state, std::uint32_t body);
/// Whether a body rotates so fast that its world inertia changes noticeably within a step of dt seconds; for bodies
/// without contacts, whether it rotates at all.
bool isFastRotating(const WorldState& state, std::uint32_t body, float dt);
/// For a body that rotates slowly: its angular momentum is computed from its angular velocity. The solver rotates it
/// too coarsely to conserve the energy of a slender body with its angular momentum.
void forgetAngularMomentum(WorldState& state, std::uint32_t body);
/// Rotates a fast body by the torque-free motion of a sub-step of h seconds; the first sub-step is 0. Angular momentum
/// and energy are conserved for any inertia.
void rotateFreely(WorldState& state, std::uint32_t body, int subStep, float h);
/// Applies the rotation of a step of `subSteps` of h seconds to the pose, and updates world inertia, angular momentum
/// and angular velocity. The angular momentum of a body that was not touched is conserved, the energy of all others.
void applyRotation(WorldState& state, std::uint32_t body, int subSteps, float h);

}  // namespace rubble
