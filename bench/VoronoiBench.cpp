// Measures the Voronoi cells of random seeds, clipped to the unit square, against CGAL and Boost.Polygon.
#include "bench/Peers.h"
#include "bench/RatioReporter.h"
#include "bench/SeedSets.h"
#include "core/fracture/voronoi/VoronoiPartition.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

using namespace rubble;
using namespace rubble::bench;

namespace {

constexpr double kAreaTolerance = 1e-9;
const Polygon kUnitSquare = {{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}, {}};

double areaOf(const Partition& partition) {
    double sum = 0.0;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) sum += pieceArea(partition, piece);
    return sum;
}

Partition ourCells(std::span<const Vec2> seeds, int threads) {
    TaskContext task;
    task.threads = threads;
    return *voronoiPartition(kUnitSquare, seeds, task);
}

/// Runs `cells` on one set of seeds after the other. The first run is a warm-up; the areas of the last one are
/// verified.
template <class MakeCells>
void measure(benchmark::State& state, MakeCells cells) {
    InputRotation<SeedList> sets(seedSets(static_cast<std::size_t>(state.range(0))));
    auto last = cells(sets.next());
    for (auto _ : state) {
        last = cells(sets.next());
        benchmark::DoNotOptimize(last);
    }
    const double area = areaOf(last);
    if (std::abs(area - 1.0) <= kAreaTolerance) return;
    std::fprintf(stderr, "The cells' areas sum to %.17g instead of 1.\n", area);
    std::exit(1);
}

template <class MakeCells>
benchmark::internal::Benchmark* add(const char* name, MakeCells cells) {
    return benchmark::RegisterBenchmark(name, [cells](benchmark::State& state) { measure(state, cells); })
        ->RangeMultiplier(10)
        ->Arg(20)
        ->Range(100, 1'000'000)
        ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
    add("ours", [](std::span<const Vec2> seeds) { return ourCells(seeds, 1); });
    add("ours on 2 threads", [](std::span<const Vec2> seeds) { return ourCells(seeds, 2); })->UseRealTime();
    add("CGAL", cellsByCgal);
    add("Boost.Polygon", cellsByBoost);
    RatioReporter reporter("seeds", {"ours", "ours on 2 threads", "CGAL", "Boost.Polygon"},
                           {{"CGAL", "ours"}, {"Boost.Polygon", "ours"}, {"CGAL", "ours on 2 threads"}});
    return runBenchmarks(argc, argv, reporter);
}
