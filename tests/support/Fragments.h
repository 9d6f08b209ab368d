#pragma once

#include "core/asset/Bake.h"
#include "tests/support/Outlines.h"

namespace rubble {

inline Asset assetOf(Polygon outline, double depth) {
    Asset asset;
    asset.prism = {std::move(outline), depth};
    return asset;
}

/// A pattern of one layer that scatters seeds.
inline Pattern scatterOf(std::uint32_t count, std::uint32_t layer) {
    Pattern pattern;
    pattern.layers.push_back({.id = layer, .randomSeed = 7, .parameters = UniformScatter{.count = count}});
    return pattern;
}

/// The square ring with one more hole in its left side, half a metre deep, volume 5.98, as asset "old ring" in 12 cells: some
/// go around a corner, some are cut apart, one has a hole. Those of half a cubic metre and more are cut in three again.
inline Asset ringAsset() {
    Polygon outline = squareRing();
    outline.holes.push_back(reversed(rectangle({0.4, 2.0}, {0.6, 2.2})));
    Asset asset = assetOf(outline, 0.5);
    asset.id = 3;
    asset.name = "old ring";
    asset.material = 1;
    asset.pattern = scatterOf(12, 4);
    asset.levels.push_back({scatterOf(3, 5), 0.5});
    return asset;
}

/// A piece with its outline about `offset`, as an outline of the prism's frame is given.
inline BakedFragment fragmentOf(Polygon outline, std::vector<std::uint32_t> across, double depth, Vec2 offset) {
    for (Vec2& corner : outline.outer) corner -= offset;
    for (Ring& hole : outline.holes) {
        for (Vec2& corner : hole) corner -= offset;
    }
    BakedFragment fragment;
    fragment.solid.outline = std::move(outline);
    fragment.solid.across = std::move(across);
    fragment.solid.depth = depth;
    fragment.solid.offset = {offset.x, offset.y, 0.0};
    return fragment;
}

/// The left half of the unit square, cut off at x = 0.5, 2 deep; its neighbour is fragment 1.
inline BakedFragment leftHalf() {
    return fragmentOf({rectangle({0.0, 0.0}, {0.5, 1.0}), {}}, {kNone, 1, kNone, kNone}, 2.0, {0.25, 0.5});
}

/// The right half; its neighbour is fragment 0.
inline BakedFragment rightHalf() {
    return fragmentOf({rectangle({0.5, 0.0}, {1.0, 1.0}), {}}, {kNone, kNone, kNone, 0}, 2.0, {0.75, 0.5});
}

}  // namespace rubble
