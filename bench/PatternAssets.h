#pragma once

#include "bench/BoxAssets.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rubble::bench {

/// Bricks twice as long as high, with the area of a square of `side` metres.
inline BrickBond bricks(BondKind bond, double side) {
    const double height = side / std::sqrt(2.0);
    return {.bond = bond, .length = 2.0 * height, .width = height, .height = height, .mortar = 0.0};
}

inline Asset assetOf(std::vector<LayerParameters> layers) {
    Asset asset = boxAsset({});
    asset.pattern.layers.clear();
    for (std::uint32_t id = 1; LayerParameters & parameters : layers) {
        asset.pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = std::move(parameters)});
        ++id;
    }
    return asset;
}

/// One asset per kind of pattern, with about `pieces` pieces each; the uniform scatter comes first.
inline std::vector<std::pair<std::string, Asset>> patternAssets(std::uint32_t pieces) {
    const double row = std::sqrt(pieces), side = 1.0 / row;  // squares along the 1 m side of the box; m, of one of them
    const auto rounded = [](double count) { return static_cast<std::uint32_t>(std::lround(count)); };
    const UniformScatter scatter{.count = pieces};
    const std::uint32_t rings = rounded(row / std::sqrt(1.25)), cuts = rounded(row) - 1,
                        rotated = rounded(0.978 * row) - 1;
    const std::vector<Vec2> crack{{-0.1, 0.4}, {0.4, 0.55}, {0.7, 0.45}, {1.1, 0.6}};
    return {{"scatter", assetOf({scatter})},
            {"blue noise", assetOf({BlueNoise{.minimumDistance = 0.5 * side, .count = pieces}})},
            {"grid", assetOf({JitteredGrid{.columns = rounded(row), .rows = rounded(row)}})},
            {"clusters", assetOf({Clusters{.clusters = pieces / 100, .seedsPerCluster = 100, .radius = 0.05}})},
            {"radial",
             assetOf({RadialPattern{.centre = {0.5, 0.5}, .radius = 0.5, .rings = rings, .spokes = pieces / rings}})},
            {"impact", assetOf({ImpactScatter{.centre = {0.5, 0.5}, .count = pieces}})},
            {"grain", assetOf({scatter, Grain{.angle = 0.3}})},
            {"crack lines", assetOf({scatter, CrackLines{{{0, crack}}}})},
            {"stretcher", assetOf({bricks(BondKind::Stretcher, side)})},
            {"stack", assetOf({bricks(BondKind::Stack, side)})},
            {"english", assetOf({bricks(BondKind::English, 1.2247 * side)})},
            {"header", assetOf({bricks(BondKind::Header, 1.4142 * side)})},
            {"flemish", assetOf({bricks(BondKind::Flemish, 1.1547 * side)})},
            {"slices", assetOf({Slices{.cuts = cuts, .angleVariation = 0.0},
                                Slices{.cuts = cuts, .angle = 0.0, .angleVariation = 0.0}})},
            {"rotated slices", assetOf({Slices{.cuts = rotated}, Slices{.cuts = rotated, .angle = 0.0}})}};
}

}  // namespace rubble::bench
