#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/asset/mesh/FragmentMesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble::bench {

double wholeMeshCase(std::size_t n) {
    constexpr int kRuns = 3;
    Asset asset{.id = 1, .name = "prism"};
    asset.prism.depth = 0.5;
    for (std::size_t k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
        asset.prism.outline.outer.push_back({std::cos(angle), std::sin(angle)});
    }
    const Bake baked = bake(asset).value();
    double best = 1e308;
    for (int run = 0; run < kRuns; ++run) {
        best = std::min(best, millisecondsOf([&] { static_cast<void>(wholeMesh(baked, asset)); }));
    }
    return best;
}

}  // namespace rubble::bench
