#include "core/play/damage/BondLayout.h"

#include <algorithm>

namespace rubble {
namespace {

/// The paths of the fragments of a bond.
std::string pathsOf(const PlayStructure& structure, const Bond& bond) {
    const Bake& bake = *structure.asset->bake;
    std::string paths = bake.fragmentPath(structure.fragmentOf(bond.first));
    if (bond.second != kNone) paths += " " + bake.fragmentPath(structure.fragmentOf(bond.second));
    return paths;
}

/// The bonds by their fragments; of several between the same, as two anchors of a fragment, the first.
std::map<std::string, std::uint32_t> bondsByPaths(const BondLayout& layout) {
    std::map<std::string, std::uint32_t> bonds;
    for (std::size_t k = 0; k < layout.structures.size(); ++k) {
        const std::vector<Bond>& ofOne = layout.structures[k]->graph.bonds;
        for (std::uint32_t bond = 0; bond < ofOne.size(); ++bond) {
            bonds.try_emplace(pathsOf(*layout.structures[k], ofOne[bond]), layout.firstBond[k] + bond);
        }
    }
    return bonds;
}

std::string pathsAt(const BondLayout& layout, std::uint32_t bond) {
    const auto next = std::ranges::upper_bound(layout.firstBond, bond);
    const auto k = static_cast<std::size_t>(next - layout.firstBond.begin()) - 1;
    return pathsOf(*layout.structures[k], layout.structures[k]->graph.bonds[bond - layout.firstBond[k]]);
}

}  // namespace

std::uint32_t BondLayout::structureOf(std::uint32_t parent) const {
    const auto isIt = [&](const auto& structure) { return structure->parent == parent; };
    const auto found = std::ranges::find_if(structures, isIt);
    return found != structures.end() ? static_cast<std::uint32_t>(found - structures.begin()) : kNone;
}

BondLayout bondLayout(const PlayScene& scene, const PlayOrigin& origin) {
    BondLayout layout{.firstBond = {0}};
    const auto add = [&](std::uint32_t parent) {
        std::shared_ptr<const PlayStructure> structure = structureIn(scene, origin, parent);
        if (structure == nullptr) return;
        layout.firstBond.push_back(layout.firstBond.back() + structure->graph.bondCount());
        layout.structures.push_back(std::move(structure));
    };
    const auto structures = scene.assetStructures.find({origin.asset, origin.variant});
    if (structures == scene.assetStructures.end()) return layout;
    add(kNone);
    for (const auto& [parent, structure] : structures->second) {
        if (parent != kNone) add(parent);
    }
    return layout;
}

InstanceDamage intactBonds(ContentHash bake, const BondLayout& layout) {
    return {.kind = DamageKind::Bonds, .bake = bake, .broken = std::vector<bool>(layout.count())};
}

std::optional<std::string> bondDamageFault(const InstanceDamage& damage, ContentHash bake, const BondLayout& layout) {
    const InstanceDamage intact = intactBonds(bake, layout);
    if (const Result<InstanceDamage> merged = mergedDamage(damage, intact); !merged) return merged.error().message;
    if (damage.cut) return "The damage has a cut, but the asset breaks along bonds.";
    const auto isWrong = [&](const auto& bond) {
        return bond.first >= damage.broken.size() || damage.broken[bond.first] || bond.second == 0 ||
               bond.second == 255;
    };
    if (std::ranges::any_of(damage.partial, isWrong)) return "The damage of a bond is wrong.";
    return std::nullopt;
}

Result<RemappedDamage> remappedBonds(const InstanceDamage& damage, const BondLayout& from, const BondLayout& to,
                                     ContentHash bake) {
    if (const auto fault = bondDamageFault(damage, damage.bake, from)) return Error{ErrorCode::BadInput, *fault};
    RemappedDamage remapped{.damage = intactBonds(bake, to)};
    const std::map<std::string, std::uint32_t> bonds = bondsByPaths(to);
    const auto map = [&](std::uint32_t bond, const auto& apply) {
        const std::string paths = pathsAt(from, bond);
        const auto found = bonds.find(paths);
        if (found != bonds.end()) {
            apply(found->second);
        } else {
            remapped.dropped.push_back(paths);
        }
    };
    for (std::uint32_t bond = 0; bond < damage.broken.size(); ++bond) {
        if (damage.broken[bond]) map(bond, [&](std::uint32_t there) { remapped.damage.broken[there] = true; });
    }
    for (const auto& [bond, one] : damage.partial) {
        map(bond, [&, part = one](std::uint32_t there) { remapped.damage.partial[there] = part; });
    }
    std::erase_if(remapped.damage.partial, [&](const auto& bond) { return remapped.damage.broken[bond.first]; });
    return remapped;
}

}  // namespace rubble
