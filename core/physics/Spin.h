#pragma once

#include "core/physics/WorldState.h"

namespace rubble {

/// The angular momentum of a body about its centre, in world axes: what it kept, and what changes of its spin added since.
Vec3f angularMomentum(const WorldState& state, std::uint32_t body);
/// True for a body that turns so fast that its inertia changes much within a step of dt seconds, or that flies and turns at all.
bool isSpinner(const WorldState& state, std::uint32_t body, float dt);
/// Turns such a body on by h seconds: angular momentum is kept exactly, and energy does not drift, as the step is the same
/// backwards.
/// Source: Hairer, Lubich, Wanner 2006, "Geometric numerical integration", VII.5 (midpoint rule).
Quatf turnedBySpin(const WorldState& state, std::uint32_t body, float h);
/// The world inertia of a body that was turned, and the spin that keeps its angular momentum.
void takeTurn(WorldState& state, std::uint32_t body);

}  // namespace rubble
