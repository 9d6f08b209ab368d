#pragma once

#include "core/physics/WorldState.h"

#include <string_view>

namespace rubble {

/// Whether no coordinate is larger than `most`; never where one is not a number.
bool isWithin(Vec3 v, double most);
/// What is wrong with the pose of something, as a sentence, or nothing.
std::optional<std::string> faultOf(const Pose& pose, std::string_view what);
/// What keeps a body from being made, as a sentence, or nothing.
std::optional<std::string> faultOf(const BodyDefinition& definition);
/// Makes a body of a definition without fault.
std::uint32_t addBody(WorldState& state, const BodyDefinition& definition);
/// Makes a body of something else: mass and inertia if it is dynamic, friction and restitution.
void giveMaterial(WorldState& state, std::uint32_t body, const BodyMaterial& material);
/// Takes a body out; what touched it wakes.
void removeBody(WorldState& state, std::uint32_t body);
/// Puts the shape's frame elsewhere.
void placeBody(WorldState& state, std::uint32_t body, const Pose& pose);
/// The pose of the shape's frame.
Pose poseOf(const WorldState& state, std::uint32_t body);

}  // namespace rubble
