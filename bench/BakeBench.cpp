// Measures a bake in memory: seeds, cells, and fragments with mass properties, neighbours, outlines and hulls. CGAL's
// time is that of the triangulation and its dual only: "CGAL" computes the circumcentre of every triangle, "CGAL's
// cells" also collects the corners of each cell and clips cells at the square's edge.
#include "bench/BoxAssets.h"
#include "bench/Peers.h"
#include "bench/RatioReporter.h"
#include "core/asset/bake/Bake.h"

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr std::size_t kPieces = 50'000;

template <class Input, class Work>
benchmark::internal::Benchmark* add(const char* name, std::vector<Input> (*make)(std::size_t), Work work) {
    const auto measure = [make, work](benchmark::State& state) {
        InputRotation<Input> inputs(make(static_cast<std::size_t>(state.range(0))));
        auto last = work(inputs.next());  // warm-up
        for (auto _ : state) {
            last = work(inputs.next());
            benchmark::DoNotOptimize(last);
        }
    };
    return benchmark::RegisterBenchmark(name, measure)->Arg(kPieces)->Unit(benchmark::kMillisecond);
}

Bake baked(const Asset& asset, int threads) {
    TaskContext task;
    task.threads = threads;
    return bake(asset, task).value();
}

}  // namespace

int main(int argc, char** argv) {
    add("ours", boxAssets, [](const Asset& asset) { return baked(asset, 1); });
    add("ours on 2 threads", boxAssets, [](const Asset& asset) { return baked(asset, 2); })->UseRealTime();
    add("CGAL", seedSets, [](const SeedList& seeds) { return dualByCgal(seeds); });
    add("CGAL's cells", seedSets, [](const SeedList& seeds) { return cellsByCgal(seeds); });
    RatioReporter reporter("pieces", {"ours", "ours on 2 threads", "CGAL", "CGAL's cells"},
                           {{"CGAL", "ours"},
                            {"CGAL", "ours on 2 threads"},
                            {"CGAL's cells", "ours"},
                            {"CGAL's cells", "ours on 2 threads"}});
    return runBenchmarks(argc, argv, reporter);
}
