#pragma once

#include "core/asset/Project.h"
#include "core/physics/World.h"

namespace rubble {

/// What a shot without faults throws, where and how fast it starts: its centre of mass at the shot's start, its z axis back along the flight and its
/// x axis level. A shape of its own, or for ProjectileKind::Asset the whole of `asset`, whose material then says its density;
/// else its mass is the shot's.
///
/// Errors: those of makeShape() for a size of no use, and BadInput where a body cannot be so heavy or so light.
Result<BodyDefinition> missile(const Throw& thrown, const std::shared_ptr<const Shape>& asset,
                               const Material* material);

/// The hulls of a plain missile about its centre: a box, a plank (a box), or a ball of 92 corners.
Polytope missileHull(const Throw& thrown);

}  // namespace rubble
