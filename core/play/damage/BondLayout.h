#pragma once

#include "core/play/damage/DamageRemap.h"
#include "core/play/scene/PlayScene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The bonds of all structures that a bonded solid can have, in one order: those of the whole, with anchors, then those
/// of the fragments that are fractured, by number. An InstanceDamage counts them so.
struct BondLayout {
    std::vector<std::shared_ptr<const PlayStructure>> structures;
    std::vector<std::uint32_t> firstBond;  // of each structure, and the end

    std::uint32_t count() const { return firstBond.back(); }
    /// The index of a structure by its parent; kNone: there is none.
    std::uint32_t structureOf(std::uint32_t parent) const;
};

/// Of an origin of a scene; without structures if it does not break along bonds.
BondLayout bondLayout(const PlayScene& scene, const PlayOrigin& origin);

/// The damage of an instance none of whose bonds was hit.
InstanceDamage intactBonds(ContentHash bake, const BondLayout& layout);

/// Why a damage cannot be of these bonds, as a sentence; as damageFault().
std::optional<std::string> bondDamageFault(const InstanceDamage& damage, ContentHash bake, const BondLayout& layout);

/// Maps a damage to the bonds of another bake, by the paths of the fragments that they are between, as
/// remappedDamage(). `dropped` has the paths of both fragments of a bond: "5.17 5.18", or "5.17" of an anchor.
///
/// Errors: BadInput as bondDamageFault().
Result<RemappedDamage> remappedBonds(const InstanceDamage& damage, const BondLayout& from, const BondLayout& to,
                                     ContentHash bake);

}  // namespace rubble
