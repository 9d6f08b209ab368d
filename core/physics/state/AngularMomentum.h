#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// The angular momentum of a body about its centre, in world axes, between two steps.
Vec3f angularMomentum(const WorldState& state, std::uint32_t body);
/// Begins a step of dt seconds. Returns whether the body rotates so fast that its world inertia changes noticeably
/// within the step, or, without contacts, whether it rotates at all: then rotateFreely() rotates it. The solver rotates
/// others, too coarsely to conserve the energy of a slender body with its angular momentum.
bool beginRotation(WorldState& state, std::uint32_t body, float dt);
/// Rotates a fast body by the torque-free motion of a sub-step of h seconds. Angular momentum and energy are conserved
/// for any inertia.
void rotateFreely(WorldState& state, std::uint32_t body, float h);
/// Applies the rotation of a step of `subSteps` of h seconds to the pose, and updates world inertia, angular momentum
/// and angular velocity. The angular momentum of a fast body that was not touched is conserved, the energy of others.
void applyRotation(WorldState& state, std::uint32_t body, int subSteps, float h);

}  // namespace rubble
