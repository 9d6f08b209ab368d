// Measures a bake of 50,000 pieces, from seeds or cuts to fragments, by each kind of pattern, relative to a uniform
// scatter.
#include "bench/PatternAssets.h"
#include "bench/Peers.h"
#include "bench/RatioReporter.h"
#include "core/asset/bake/Bake.h"

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr std::uint32_t kPieces = 50'000;

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> names;
    std::vector<Ratio> ratios;
    for (const auto& [name, asset] : patternAssets(kPieces)) {
        const auto measure = [asset = asset](benchmark::State& state) {
            Bake last = bake(asset).value();  // warm-up
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
