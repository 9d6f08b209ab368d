#pragma once

#include "core/asset/bake/Bake.h"
#include "core/fracture/fragments/Extrusion.h"
#include "tests/support/geometry/Outlines.h"

#include <string>
#include <vector>

namespace rubble {

inline Asset assetOf(Polygon outline, double depth) {
    Asset asset;
    asset.shape = Prism{std::move(outline), depth};
    return asset;
}

/// A pattern of one layer that scatters seeds.
inline Pattern scatterOf(std::uint32_t count, std::uint32_t layer) {
    Pattern pattern;
    pattern.layers.push_back({.id = layer, .randomSeed = 7, .parameters = UniformScatter{.count = count}});
    return pattern;
}

/// A level of one layer that scatters seeds; the layer's random seed is its id.
inline Level scatteredLevel(Id layer, std::uint32_t count, double minimumVolume = 0.0) {
    return {{{{.id = layer, .randomSeed = layer, .parameters = UniformScatter{.count = count}}}}, minimumVolume};
}

/// The square ring with one more hole in its left side, half a metre deep, volume 5.98, as asset "old ring" in 12
/// cells: some go around a corner, some are cut apart, one has a hole. Those of half a cubic metre and more are cut in
/// three again.
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

/// A piece with its outline as the prism's frame has it, and the piece behind each edge, ring after ring.
struct LoosePiece {
    Polygon outline;
    std::vector<std::uint32_t> neighbours;
};

/// A bake of one level with these pieces as fragments, whose corners need not fit together.
inline Bake bakeOf(const std::vector<LoosePiece>& pieces, double depth) {
    Partition partition;
    partition.ringsOfPiece = {0};
    partition.cornersOfRing = {0};
    const auto addRing = [&](const Ring& ring) {
        for (const Vec2 corner : ring) {
            partition.corners.push_back(static_cast<std::uint32_t>(partition.points.size()));
            partition.points.push_back(corner);
        }
        partition.cornersOfRing.push_back(static_cast<std::uint32_t>(partition.corners.size()));
    };
    for (const LoosePiece& piece : pieces) {
        addRing(piece.outline.outer);
        for (const Ring& hole : piece.outline.holes) addRing(hole);
        partition.neighbours.insert(partition.neighbours.end(), piece.neighbours.begin(), piece.neighbours.end());
        partition.seedOfPiece.push_back(partition.pieceCount());
        partition.pieceOfSeed.push_back(partition.pieceCount() - 1);
        partition.ringsOfPiece.push_back(static_cast<std::uint32_t>(partition.cornersOfRing.size()) - 1);
    }
    Bake bake;
    bake.fractures.resize(1);
    bake.fractures[0].fragments = *extrudedFragments({pieces[0].outline, depth}, std::move(partition));
    return bake;
}

/// The unit square cut in two at x = 0.5, 2 deep: fragment 0 is the left half, fragment 1 the right one.
inline Bake halvedSquare() {
    return bakeOf({{{rectangle({0.0, 0.0}, {0.5, 1.0}), {}}, {kNone, 1, kNone, kNone}},
                   {{rectangle({0.5, 0.0}, {1.0, 1.0}), {}}, {kNone, kNone, kNone, 0}}},
                  2.0);
}

/// The ids of all fragments, in order.
inline std::vector<std::string> idsOf(const Bake& bake) {
    std::vector<std::string> ids;
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) ids.push_back(bake.fragmentId(k));
    return ids;
}

}  // namespace rubble
