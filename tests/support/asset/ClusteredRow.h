#pragma once

#include "tests/support/asset/Projects.h"

namespace rubble::test {

/// A bonded bar of 8 x 1 x 0.5 m, in eight fragments of 1 m side by side: "3.0" to "3.7".
inline Asset rowOfEight() {
    Asset asset = boxAsset(2, 3, PlacedSeeds{});
    asset.prism().outline = {rectangle({0.0, 0.0}, {8.0, 1.0}), {}};
    PlacedSeeds seeds;
    for (std::uint32_t k = 0; k < 8; ++k) seeds.seeds.push_back({k, {0.5 + k, 0.5}});
    asset.pattern.layers[0].parameters = seeds;
    asset.breakAs = BreakAs::Bonded;
    asset.bonding.impulsePerArea = 200.0;
    return asset;
}

inline Asset clusteredRow(std::vector<FragmentCluster> clusters) {
    Asset asset = rowOfEight();
    asset.bonding.clusters = std::move(clusters);
    sortClusters(asset.bonding.clusters);
    return asset;
}

}  // namespace rubble::test
