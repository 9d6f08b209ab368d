#include "viewport/scene/BondStrengths.h"

#include "core/asset/project/Variants.h"
#include "core/asset/strength/BondStrength.h"
#include "core/structure/capacity/BondCapacities.h"
#include "core/structure/capacity/StrengthMap.h"

#include <cmath>
#include <limits>

namespace rubble {
namespace {

/// Whether each fragment of a bake never breaks.
std::vector<bool> neverBreakingFragments(const Asset& asset, const Bake& bake) {
    std::vector<bool> all(bake.fragmentCount(), false);
    for (std::uint32_t fracture = 0; fracture < bake.fractures.size(); ++fracture) {
        const std::vector<bool> ofFracture = neverBreaking(asset, bake, fracture);
        std::copy(ofFracture.begin(), ofFracture.end(), all.begin() + bake.fractures[fracture].first);
    }
    return all;
}

}  // namespace

std::vector<double> bondStrengths(const AssetModel& model, const Project& project) {
    std::vector<double> strengths(model.solids.size(), std::numeric_limits<double>::quiet_NaN());
    const Asset* current = findAsset(project, model.asset.id);
    if (current == nullptr || current->breakAs != BreakAs::Bonded || !model.bake || !model.bonds) return strengths;
    const Asset asset = variantOf(*current, model.variant);
    const double impulse = bondImpulseOf(asset, *findMaterial(project, asset.material));
    const StrengthMap map(asset);
    const std::vector<bool> neverBreaks = neverBreakingFragments(asset, *model.bake);
    std::vector<double> levels;
    for (std::uint32_t k = 0; k < model.bake->fractures.size(); ++k)
        levels.push_back(levelStrength(asset, *model.bake, k));
    std::vector<double> areas(strengths.size(), 0.0), loads(strengths.size(), 0.0);
    for (const ModelBond& bond : *model.bonds) {
        const auto isKept = [&](std::uint32_t solid) { return neverBreaks[model.solids[solid].fragment]; };
        const bool canBreak = !isKept(bond.first) || !isKept(bond.second);
        const double strength = impulse * levels[bond.fracture] * map.at(bond.centroid);
        for (const std::uint32_t solid : {bond.first, bond.second}) {
            if (std::isnan(strengths[solid])) strengths[solid] = std::numeric_limits<double>::infinity();
            if (!canBreak) continue;
            areas[solid] += bond.area;
            loads[solid] += bond.area * strength;
        }
    }
    for (std::size_t solid = 0; solid < strengths.size(); ++solid) {
        if (areas[solid] > 0.0) strengths[solid] = loads[solid] / areas[solid];
    }
    return strengths;
}

}  // namespace rubble
