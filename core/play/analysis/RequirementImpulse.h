#pragma once

#include "core/play/scene/PlayStructure.h"

namespace rubble {

/// How an asset is held when a body hits it.
enum class AssetSupport {
    Free,   // it gives way, which takes impulse off the hit
    Fixed,  // its instances are held in place: it gives way nowhere
};

/// The support that decides an event: Fixed for a hit if all instances of the asset that can break are held in place,
/// and otherwise Free. Where some of them are, the one that demands more: Fixed to survive, Free to break. Drops are
/// always Free.
AssetSupport supportOf(const Project& project, const Asset& asset, const StrengthRequirement& requirement);

/// The damage of a requirement's event to an asset, N·s: that of a session at the first contact, by the project's
/// damage rule; 0 if the contact is too slow to do any.
///
/// In closed form: a body falling from height h lands at sqrt(2 g h); a hit asset is at rest, and held as supportOf()
/// says. The two bodies are placed in contact with their velocities; one collision step gives contact points and
/// effective mass, and nothing is simulated. Of several contacts the largest counts. Later contacts, for example after
/// tipping over, are ignored. A drop uses level ground with the project's restitution and the project's gravity.
/// `asset` belongs to the project.
///
/// Errors: BadInput for a drop if gravity does not point straight down; those of projectileBody() and World::addBody(),
/// for a mass or speed that cannot be simulated.
Result<double> requirementImpulse(const Project& project, const PlayAsset& asset,
                                  const StrengthRequirement& requirement);

/// What a requirement's event does to an asset that breaks along bonds.
struct RequirementImpact {
    double impulse = 0.0;      // N·s, of the hardest contact; 0 if it is too slow to do any damage
    std::vector<Vec3> points;  // m, in the prism's frame: of all contacts
};

/// The same at the points of contact, whatever the damage rule. An impulse without a body acts where hits do: at the
/// front, see hitThrow().
///
/// Errors: as above.
Result<RequirementImpact> requirementImpact(const Project& project, const PlayAsset& asset,
                                            const StrengthRequirement& requirement);

/// The fraction of the impulse of a hit that is left at the corner of the front that is farthest from the centre of
/// mass, in (0, 1]: the least that a hit along the normal of the front can have, since a free asset rotates away. 1 if
/// fixed, and by DamageRule::Momentum, which knows no rotation.
///
/// In closed form, for a body of mass m that does not rotate itself: the inverse effective mass at the centre, 1/m +
/// 1/M, divided by that at the corner.
double cornerFraction(const Project& project, const PlayAsset& asset, const HitRequirement& hit, AssetSupport support);

/// The throw of a hit, in the prism's frame: a cube of 0.2 m, or of a fifth of the outline if that is less, that starts
/// in head-on contact with the front (z > 0) in front of the centre of mass, or, if the centre lies outside the
/// outline, of the nearest point of the outline.
Throw hitThrow(const Project& project, const PlayAsset& asset, const HitRequirement& hit);

/// The support value of a shape along a direction, from the origin of its frame, m.
double supportAlong(const Shape& shape, Vec3 direction);

}  // namespace rubble
