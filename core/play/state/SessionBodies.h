#pragma once

#include "core/play/state/SessionState.h"

namespace rubble {

const Material& materialOf(const SessionState& state, const PlayScene& scene, Id asset);
/// The physical material of a body of an asset. With the thesis preset every fragment weighs 100 kg.
BodyMaterial bodyMaterial(const SessionParts& parts, const PlayAsset& asset, std::uint32_t fragment, PlayRole role);
/// The threshold of a body, N·s; infinite for a body that does not break.
double thresholdOf(const SessionState& state, const PlayScene& scene, const PlayBody& body);
/// The body with a number; null if it is gone.
PlayBody* findBody(SessionState& state, std::uint32_t number);
const PlayBody* findBody(const SessionState& state, std::uint32_t number);

/// The distance of a point from a body, m; 0 inside.
double distanceToBody(const World& world, BodyId body, Vec3 point);

/// The potential energy of the fragments in held bodies, J, zero at the origin.
double heldPotential(const PlayScene& scene, const SessionState& state, const World& world);

/// Adds a body to world and list, with the next number.
///
/// Errors: those of World::addBody().
Result<std::uint32_t> addBody(SessionParts& parts, BodyDefinition definition, PlayBody body);
/// A body as it is before it is removed.
PlayRemoval removalOf(const SessionParts& parts, const PlayBody& body, RemovalReason reason);
/// Removes a body from the world. It stays in the list, without a world id, until eraseRemovedBodies().
void removeFromWorld(SessionParts& parts, std::uint32_t number);
/// Returns the number of bodies visited.
std::size_t eraseRemovedBodies(SessionState& state);

/// Adds the ground and all instances.
///
/// Errors: those of World::addBody(), with the instance's name.
Status placeScene(SessionParts& parts);

}  // namespace rubble
