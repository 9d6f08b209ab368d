#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// Adds a body of a valid definition. Returns its index.
std::uint32_t addBody(WorldState& state, const BodyDefinition& definition);
/// The same without its pose and proxies, which must follow.
std::uint32_t addUnplacedBody(WorldState& state, const BodyDefinition& definition);
/// Sets the friction, restitution and, if it is dynamic, mass and inertia of a body.
void setMaterial(WorldState& state, std::uint32_t body, const BodyMaterial& material);
/// Removes a body and wakes those that touch it.
void removeBody(WorldState& state, std::uint32_t body);
/// Sets the pose of the shape's frame.
void setPose(WorldState& state, std::uint32_t body, const Pose& pose);
/// The pose of the shape's frame.
Pose poseOf(const WorldState& state, std::uint32_t body);

}  // namespace rubble
