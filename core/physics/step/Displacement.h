#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// The pose of a body at the end of the step being solved; its inertia is that of the beginning.
BodyPose poseAfter(const WorldState& state, std::uint32_t body);

/// An upper bound of how far the points of a body move in it by its rotation, m.
float arcOf(const WorldState& state, std::uint32_t body);
/// An upper bound of how far they move, m.
float reachOf(const WorldState& state, std::uint32_t body);
/// The same, up to 1.8 times as much, and quicker.
float maxReachOf(const WorldState& state, std::uint32_t body);

/// Whether the bodies of a contact without a manifold may have touched in it.
bool mayHaveTouched(const WorldState& state, const SeparatedContact& contact);

/// Corrects the displacement of a body in the step being solved, m, for what is not dynamic. Height that the body gains
/// by it is taken from its motion, as far as that suffices, since nothing else would pay for it.
void correctDisplacement(WorldState& state, std::uint32_t body, Vec3f displacement);

}  // namespace rubble
