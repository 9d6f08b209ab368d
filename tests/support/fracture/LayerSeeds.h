#pragma once

#include "core/fracture/pattern/Pattern.h"

#include <map>
#include <utility>

namespace rubble {

/// The seeds of a pattern of one layer.
inline Result<Seeds> layerSeeds(LayerParameters parameters, const Polygon& outline, std::uint64_t randomSeed) {
    return seedsOf({{{.id = 1, .randomSeed = randomSeed, .parameters = std::move(parameters)}}}, outline);
}

/// The positions of seeds of one layer by their indices in it.
inline std::map<std::uint32_t, Vec2> positionsByIndex(const Seeds& seeds) {
    std::map<std::uint32_t, Vec2> positions;
    for (std::size_t k = 0; k < seeds.ids.size(); ++k) positions[seeds.ids[k].index] = seeds.positions[k];
    return positions;
}

}  // namespace rubble
