#include "core/structure/capacity/BondCapacities.h"

#include "core/asset/project/FragmentLevels.h"
#include "core/asset/strength/BondStrength.h"
#include "core/structure/capacity/BondPainting.h"
#include "core/structure/capacity/StrengthMap.h"

#include <algorithm>
#include <limits>

namespace rubble {
namespace {

bool isListed(const Bonding& bonding, const FragmentPath& path) {
    return std::ranges::any_of(bonding.neverBreaks, [&](const FragmentPath& listed) { return isWithin(path, listed); });
}

/// Whether both ends of a bond never break; an anchor never does.
bool joinsUnbreakable(const Bond& bond, const std::vector<bool>& isUnbreakable) {
    return isUnbreakable[bond.first] && (bond.second == kNone || isUnbreakable[bond.second]);
}

}  // namespace

double levelStrength(const Asset& asset, const Bake& bake, std::uint32_t fracture) {
    const BakedFracture& baked = bake.fractures[fracture];
    if (baked.parent == kNone) return 1.0;
    const Level* level = levelFor(asset, bake.fragmentPath(baked.parent), baked.level - 1);
    return level ? level->bondStrength : 1.0;
}

double strengthAt(const Asset& asset, Vec2 point) { return StrengthMap(asset).at(point); }

std::vector<double> bondCapacities(const Asset& asset, const Material& material, const Bake& bake,
                                   std::uint32_t fracture, std::span<const Bond> bonds, double factor) {
    const StrengthMap map(asset);
    const std::vector<bool> isUnbreakable = neverBreaking(asset, bake, fracture);
    const double perArea = bondImpulseOf(asset, material) * levelStrength(asset, bake, fracture) * factor;
    std::vector<double> capacities;
    capacities.reserve(bonds.size());
    for (const Bond& bond : bonds) {
        const bool neverBreaks = joinsUnbreakable(bond, isUnbreakable);
        capacities.push_back(neverBreaks ? std::numeric_limits<double>::infinity()
                                         : perArea * bond.area * map.at(Vec2{bond.centroid}));
    }
    return capacities;
}

std::vector<bool> neverBreaking(const Asset& asset, const Bake& bake, std::uint32_t fracture) {
    const BakedFracture& baked = bake.fractures[fracture];
    std::vector<bool> isUnbreakable = paintedFragments(baked.fragments, asset.bonding.strokes, BondBrush::NeverBreaks);
    if (asset.bonding.neverBreaks.empty()) return isUnbreakable;
    for (std::uint32_t k = 0; k < isUnbreakable.size(); ++k) {
        if (isListed(asset.bonding, bake.fragmentPath(baked.first + k))) isUnbreakable[k] = true;
    }
    return isUnbreakable;
}

std::vector<std::uint32_t> anchoredFragments(const Asset& asset, const Bake& bake, std::uint32_t fracture) {
    const std::vector<bool> isAnchored =
        paintedFragments(bake.fractures[fracture].fragments, asset.bonding.strokes, BondBrush::Anchor);
    std::vector<std::uint32_t> anchored;
    for (std::uint32_t k = 0; k < isAnchored.size(); ++k) {
        if (isAnchored[k]) anchored.push_back(k);
    }
    return anchored;
}

}  // namespace rubble
