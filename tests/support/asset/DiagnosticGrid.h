#pragma once

#include "core/asset/project/Project.h"

#include <cstdint>
#include <utility>

namespace rubble::test {

/// A square with a grid of side · side seeds on the first level and three seeds, two of them equal, in each of its
/// cells: a diagnostic of the second level for each cell.
inline Asset diagnosticGrid(std::uint32_t side) {
    const double size = side;
    Asset asset{.id = 1, .name = "grid"};
    asset.shape = Prism{{{{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}, {}}, 0.5};
    PlacedSeeds cells;
    for (std::uint32_t k = 0; k < side * side; ++k) {
        cells.seeds.push_back({k, {0.5 + static_cast<double>(k % side), 0.5 + static_cast<double>(k / side)}});
    }
    asset.pattern.layers = {{.id = 2, .parameters = std::move(cells)}};
    const PlacedSeeds equal{{{0, {-0.25, 0.0}}, {1, {0.25, 0.0}}, {2, {0.25, 0.0}}}};
    asset.levels = {{.pattern = {{{.id = 3, .parameters = equal}}}}};
    return asset;
}

}  // namespace rubble::test
