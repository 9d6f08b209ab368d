#pragma once

#include "core/play/damage/InstanceDamage.h"

namespace rubble {

/// The damage of another bake of an asset, and what got lost.
struct RemappedDamage {
    InstanceDamage damage;
    std::vector<FragmentPath> dropped;  // the broken fragments that do not exist or do not break there
};

/// Maps a damage to another bake by the paths of the fragments, which stay as long as their seeds do. `from` is the
/// asset that the damage is of, `to` the one that it shall be of with its damageHash(); where the damage has a cut,
/// both are what the cut gives. A fragment whose parent is not broken there is dropped too.
///
/// Errors: BadInput if the damage is not of `from`, as damageFault().
Result<RemappedDamage> remappedDamage(const InstanceDamage& damage, const PlayAsset& from, const PlayAsset& to,
                                      ContentHash bake);

}  // namespace rubble
