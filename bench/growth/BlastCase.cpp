#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/physics/world/World.h"
#include "tests/support/geometry/Hulls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble::bench {

double blastCase(std::size_t n) {
    constexpr int kRuns = 3;
    World world({.gravity = {0.0, 0.0, 0.0}});
    const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(n))));
    const double side = 1.0 / static_cast<double>(columns);
    const std::array<Polytope, 1> box{test::boxOf({side, side, 0.05})};
    const std::shared_ptr<const Shape> shape = *makeShape(box);
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 position(side * static_cast<double>(k % columns), side * static_cast<double>(k / columns), 0.0);
        static_cast<void>(world.addBody({.shape = shape, .pose = {.position = position}}).value());
    }
    double best = 1e308;
    for (int run = 0; run < kRuns; ++run) {
        best = std::min(best, millisecondsOf([&] { static_cast<void>(world.blast({0.4, 0.6, 0.5}, 3.0, 2000.0)); }));
    }
    return best;
}

}  // namespace rubble::bench
