#pragma once

#include "core/play/scene/PlayAsset.h"

namespace rubble {

/// The instance of an asset to try a requirement on; null if the asset has none that can break. Preferred are those
/// that are held as supportOf() says, then those with the threshold of their asset, then `preferred`, then the first.
const Instance* instanceToTry(const Project& project, const Asset& asset, const StrengthRequirement& requirement,
                              Id preferred = 0);

/// The shot that plays a requirement's event at the start of a simulation, exactly as requirementImpulse() computes it:
/// the hit of hitThrow() on `instance`, from as far away as gravity leaves it unchanged; a blow of the impulse on the
/// same place; or a copy of the asset that falls, in its own orientation, beside everything else.
///
/// Errors: BadInput for a drop without ground, or with gravity that does not point straight down.
Result<ShotAction> requirementShot(const Project& project, const PlayAsset& asset,
                                   const StrengthRequirement& requirement, const Instance* instance);

}  // namespace rubble
