#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/base/math/Trigonometry.h"
#include "core/fracture/voronoi/VoronoiPartition.h"

#include <algorithm>
#include <numbers>

namespace rubble::bench {
namespace {

constexpr int kRuns = 3;

double millisecondsOfPartition(const Polygon& outline, const std::vector<Vec2>& seeds) {
    double best = 1e308;
    for (int run = 0; run < kRuns; ++run)
        best = std::min(best, millisecondsOf([&] { static_cast<void>(voronoiPartition(outline, seeds).value()); }));
    return best;
}

}  // namespace

double weldingCase(std::size_t n) {
    // Its two corners on the x axis touch the bisector of the seeds, so that both halves are examined.
    Polygon outline;
    for (std::size_t k = 0; k < n; ++k) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(n);
        outline.outer.push_back({cosine(angle), sine(angle)});
    }
    return millisecondsOfPartition(outline, {{0.0, 0.25}, {0.0, -0.25}});
}

double splitCellCase(std::size_t n) {
    // A comb of n teeth: the cell of the upper seed has n pieces.
    Polygon outline;
    outline.outer = {{0.0, 0.0}, {2.0 * static_cast<double>(n) - 1.0, 0.0}};
    for (std::size_t k = n; k-- > 0;) {
        const double left = 2.0 * static_cast<double>(k);
        if (k + 1 < n) outline.outer.push_back({left + 1.0, 1.0});
        outline.outer.push_back({left + 1.0, 4.0});
        outline.outer.push_back({left, 4.0});
        if (k > 0) outline.outer.push_back({left, 1.0});
    }
    const double middle = static_cast<double>(n) - 0.5;
    return millisecondsOfPartition(outline, {{middle, 0.5}, {middle, 3.5}});
}

}  // namespace rubble::bench
