#include "core/asset/project/Variants.h"

#include "core/base/Random.h"

#include <set>

namespace rubble {
namespace {

void mixInVariant(std::uint32_t variant, Pattern& pattern) {
    for (PatternLayer& layer : pattern.layers) {
        layer.randomSeed = mixSeeds(layer.randomSeed, variant);
        layer.overrides.clear();
    }
}

}  // namespace

Asset variantOf(Asset asset, std::uint32_t variant) {
    if (variant == 0) return asset;
    mixInVariant(variant, asset.pattern);
    for (Level& level : asset.levels) mixInVariant(variant, level.pattern);
    asset.fragmentLevels.clear();  // this and the next four: they refer to the old fragments
    asset.fragmentThresholds.clear();
    asset.bonding.neverBreaks.clear();
    asset.bonding.clusters.clear();
    asset.edits.clear();
    asset.name = nameOfVariant(asset.name, variant);
    return asset;
}

std::string nameOfVariant(const std::string& asset, std::uint32_t variant) {
    return variant == 0 ? asset : asset + "~" + std::to_string(variant);
}

AssetVariant variantOf(const Instance& instance) { return {instance.asset, instance.variant}; }

std::vector<AssetVariant> usedVariants(const Project& project) {
    std::set<AssetVariant> used;
    for (const Asset& asset : project.assets) used.insert({asset.id, 0});
    for (const Instance& instance : project.instances) {
        if (used.contains({instance.asset})) used.insert(variantOf(instance));
    }
    return {used.begin(), used.end()};
}

}  // namespace rubble
