#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/asset/mesh/FragmentMesh.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace rubble::bench {
namespace {

/// A prism on a regular n-gon, without seeds.
Asset regularPrism(std::size_t n) {
    Asset asset{.id = 1, .name = "prism"};
    asset.prism().depth = 0.5;
    for (std::size_t k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
        asset.prism().outline.outer.push_back({std::cos(angle), std::sin(angle)});
    }
    return asset;
}

double bestMilliseconds(const std::function<void()>& operation) {
    double best = std::numeric_limits<double>::infinity();
    for (int run = 0; run < 5; ++run) best = std::min(best, millisecondsOf(operation));
    return best;
}

}  // namespace

double polygonBakeCase(std::size_t n) {
    const Asset asset = regularPrism(n);
    return bestMilliseconds([&] { static_cast<void>(bake(asset).value()); });
}

double wholeMeshCase(std::size_t n) {
    const Asset asset = regularPrism(n);
    const Bake baked = bake(asset).value();
    return bestMilliseconds([&] { static_cast<void>(wholeMesh(baked, asset)); });
}

}  // namespace rubble::bench
