// Bake time of an asset with three levels of ten fragments each, compared with a thousand fragments on one level.
#include "bench/Timing.h"
#include "core/asset/bake/Bake.h"
#include "core/base/Percentile.h"

#include <cstdio>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr int kRuns = 200;

Pattern scattered(std::uint32_t layer, std::uint32_t count) {
    return {{{.id = layer, .randomSeed = layer, .parameters = UniformScatter{.count = count}}}};
}

Asset box(std::uint32_t pieces) {
    Asset asset{.id = 1, .name = "box", .material = 1};
    asset.shape = Prism{{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}}, 0.5};
    asset.pattern = scattered(1, pieces);
    return asset;
}

Asset levels(std::uint32_t depth, std::uint32_t pieces) {
    Asset asset = box(pieces);
    for (std::uint32_t level = 1; level < depth; ++level) asset.levels.push_back({scattered(level + 1, pieces), 0.0});
    return asset;
}

/// An asset that is baked repeatedly with different seeds.
struct Baked {
    Asset asset;
    std::uint32_t fragments = 0;
    std::vector<double> times = {};  // ms

    void run() {
        ++asset.pattern.layers[0].randomSeed;
        times.push_back(millisecondsOf([&] { fragments = bake(asset)->fragmentCount(); }));
    }
    double median() const { return percentile(times, 0.5); }
};

}  // namespace

int main() {
    Baked flat{box(1000)}, deep{levels(3, 10)};
    for (int run = 0; run < kRuns; ++run) {  // alternating, so that other load slows both
        flat.run();
        deep.run();
    }
    std::printf("%u pieces at once        %.3f ms\n", flat.fragments, flat.median());
    std::printf("%u pieces in 3 levels    %.3f ms, %.2f times that\n", deep.fragments, deep.median(),
                deep.median() / flat.median());
}
