#pragma once

#include "core/play/scene/PlayAsset.h"

namespace rubble {

/// The damage of a requirement's event to an asset, N·s: that of a session at the first contact, by the project's
/// damage rule; 0 if the contact is too slow to do any.
///
/// In closed form: a body falling from height h lands at sqrt(2 g h); a hit asset is free and at rest. The two bodies
/// are placed in contact with their velocities; one collision step gives contact points and effective mass, and nothing
/// is simulated. Of several contacts the largest counts. Later contacts, for example after tipping over, are ignored. A
/// drop uses level ground with the project's restitution and the project's gravity. `asset` belongs to the project.
///
/// Errors: BadInput for a drop if gravity does not point straight down; those of projectileBody() and World::addBody(),
/// for a mass or speed that cannot be simulated.
Result<double> requirementImpulse(const Project& project, const PlayAsset& asset,
                                  const StrengthRequirement& requirement);

/// The throw of a hit, in the prism's frame: a cube of 0.2 m, or of a fifth of the outline if that is less, that starts
/// in head-on contact with the front (z > 0) in front of the centre of mass, or, if the centre lies outside the
/// outline, of the nearest point of the outline.
Throw hitThrow(const Project& project, const PlayAsset& asset, const HitRequirement& hit);

}  // namespace rubble
