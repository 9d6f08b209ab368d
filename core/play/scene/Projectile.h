#pragma once

#include "core/asset/project/Project.h"
#include "core/physics/world/World.h"

namespace rubble {

/// The colour of plain projectiles.
inline constexpr Colour kProjectileColour{0.30, 0.34, 0.40};

/// The body that a valid throw starts with: its centre of mass at Throw::from, its z axis opposite to its velocity, its
/// x axis horizontal. Its shape is its own, or for ProjectileKind::Asset the whole of `asset`, whose material then
/// gives the density instead of Throw::mass.
///
/// Errors: those of makeShape() for an unusable size; BadInput for a mass outside [kMinBodyMass, kMaxBodyMass].
Result<BodyDefinition> projectileBody(const Throw& thrown, const std::shared_ptr<const Shape>& asset,
                                      const Material* material);

/// The hull of a plain projectile about its centre: a box, a plank (a box), or a ball of 92 corners.
Polytope projectileHull(const Throw& thrown);

}  // namespace rubble
