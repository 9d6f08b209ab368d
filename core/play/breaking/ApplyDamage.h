#pragma once

#include "core/play/state/SessionState.h"

namespace rubble {

/// The damage of all instances of a scene. See Session::damage().
SessionDamage damageOfInstances(const PlayScene& scene, const SessionState& state);

/// See Session::apply().
///
/// Errors: BadInput, as there.
Status applyDamage(SessionParts& parts, const SessionDamage& damage);

/// What a damage is of: the asset, or what its cut gives.
///
/// Errors: those of cutAtImpact(); BadInput for a cut of an asset that is not cut, or damageFault().
Result<std::shared_ptr<const PlayAsset>> damagedAsset(const PlayScene& scene, AssetVariant variant,
                                                      const InstanceDamage& damage);

}  // namespace rubble
