#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/asset/checks/Problems.h"

#include <algorithm>
#include <cmath>

namespace rubble::bench {

/// A square with a grid of seeds on the first level and two equal seeds in each of its n cells: n diagnostics of the
/// second level.
double problemsCase(std::size_t n) {
    constexpr int kRuns = 3;
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n))));
    const double size = side;
    Asset asset{.id = 1, .name = "grid"};
    asset.prism = {{{{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}, {}}, 0.5};
    PlacedSeeds cells;
    for (std::uint32_t k = 0; k < side * side; ++k) {
        cells.seeds.push_back({k, {0.5 + static_cast<double>(k % side), 0.5 + static_cast<double>(k / side)}});
    }
    asset.pattern.layers = {{.id = 2, .parameters = std::move(cells)}};
    const PlacedSeeds equal{{{0, {-0.25, 0.0}}, {1, {0.25, 0.0}}, {2, {0.25, 0.0}}}};
    asset.levels = {{.pattern = {{{.id = 3, .parameters = equal}}}}};
    const Bake baked = bake(asset).value();
    double best = 1e308;
    for (int run = 0; run < kRuns; ++run) {
        best = std::min(best, millisecondsOf([&] { static_cast<void>(problemsOf(asset, baked)); }));
    }
    return best;
}

}  // namespace rubble::bench
