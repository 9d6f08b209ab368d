#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/asset/checks/Problems.h"
#include "tests/support/asset/DiagnosticGrid.h"

#include <algorithm>
#include <cmath>

namespace rubble::bench {

double problemsCase(std::size_t n) {
    constexpr int kRuns = 3;
    const Asset asset =
        test::diagnosticGrid(static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n)))));
    const Bake baked = bake(asset).value();
    double best = 1e308;
    for (int run = 0; run < kRuns; ++run) {
        best = std::min(best, millisecondsOf([&] { static_cast<void>(problemsOf(asset, baked)); }));
    }
    return best;
}

}  // namespace rubble::bench
