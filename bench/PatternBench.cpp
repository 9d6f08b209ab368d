// How long 50,000 pieces take to bake, from seeds or cuts to fragments, by each kind of pattern, against a plain scatter of as many.
#include "bench/BoxAssets.h"
#include "bench/Peers.h"
#include "bench/RatioReporter.h"
#include "core/asset/Bake.h"

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr std::uint32_t kPieces = 50'000;
constexpr double kSide = 0.00447213595499958;  // m: of a square of which the box's face holds 50,000

/// Bricks twice as long as high that are as large as the squares.
BrickBond bricks(BondKind bond, double scale) {
    const double height = scale * kSide / 1.4142135623730951;
    return {.bond = bond, .length = 2.0 * height, .width = height, .height = height, .mortar = 0.0};
}

Asset assetOf(std::vector<LayerParameters> layers) {
    Asset asset = boxAsset({});
    asset.pattern.layers.clear();
    for (std::uint32_t id = 1; LayerParameters & parameters : layers) {
        asset.pattern.layers.push_back({.id = id, .randomSeed = id, .parameters = std::move(parameters)});
        ++id;
    }
    return asset;
}

/// Every kind that makes pieces in a way of its own.
std::vector<std::pair<std::string, Asset>> patterns() {
    const UniformScatter scatter{.count = kPieces};
    const std::vector<Vec2> crack{{-0.1, 0.4}, {0.4, 0.55}, {0.7, 0.45}, {1.1, 0.6}};
    return {{"scatter", assetOf({scatter})},
            {"blue noise", assetOf({BlueNoise{.minimumDistance = 0.5 * kSide, .count = kPieces}})},
            {"grid", assetOf({JitteredGrid{.columns = 224, .rows = 224}})},
            {"clusters", assetOf({Clusters{.clusters = 500, .seedsPerCluster = 100, .radius = 0.05}})},
            {"radial", assetOf({RadialPattern{.centre = {0.5, 0.5}, .radius = 0.5, .rings = 200, .spokes = 250}})},
            {"impact", assetOf({ImpactScatter{.centre = {0.5, 0.5}, .count = kPieces}})},
            {"grain", assetOf({scatter, Grain{.angle = 0.3}})},
            {"strokes", assetOf({scatter, Strokes{{{0, crack}}}})},
            {"stretcher", assetOf({bricks(BondKind::Stretcher, 1.0)})},
            {"stack", assetOf({bricks(BondKind::Stack, 1.0)})},
            {"english", assetOf({bricks(BondKind::English, 1.1547)})},
            {"header", assetOf({bricks(BondKind::Header, 1.4142)})},
            {"flemish", assetOf({bricks(BondKind::Flemish, 1.1547)})},
            {"slices", assetOf({Slices{.cuts = 223, .angleVariation = 0.0},
                                Slices{.cuts = 223, .angle = 0.0, .angleVariation = 0.0}})},
            {"turned slices", assetOf({Slices{.cuts = 218}, Slices{.cuts = 218, .angle = 0.0}})}};
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names;
    std::vector<Ratio> ratios;
    for (const auto& [name, asset] : patterns()) {
        const auto measure = [asset = asset](benchmark::State& state) {
            Bake last = bake(asset).value();  // warms memory up
            for (auto _ : state) {
                last = bake(asset).value();
                benchmark::DoNotOptimize(last);
            }
        };
        benchmark::RegisterBenchmark(name.c_str(), measure)->Arg(kPieces)->Unit(benchmark::kMillisecond);
        names.push_back(name);
        if (name != "scatter") ratios.push_back({name, "scatter"});
    }
    RatioReporter reporter("pieces", names, ratios);
    return runBenchmarks(argc, argv, reporter);
}
