#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/physics/world/World.h"
#include "tests/support/geometry/Hulls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rubble::bench {

double wakeCase(std::size_t n) {
    constexpr double kStep = 1.0 / 60.0, kSpacing = 3.0;
    constexpr int kStepsToSleep = 40, kRuns = 3;
    World world({.gravity = {0.0, 0.0, 0.0}});
    const std::array<Polytope, 1> box{test::boxOf({1.0, 1.0, 1.0})};
    const std::shared_ptr<const Shape> shape = *makeShape(box);
    const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(n))));
    for (std::size_t k = 0; k < n; ++k) {
        const Vec3 cell(static_cast<double>(k % side), static_cast<double>(k / side % side),
                        static_cast<double>(k / side / side));
        static_cast<void>(world.addBody({.shape = shape, .pose = {.position = kSpacing * cell}}).value());
    }
    for (int step = 0; step < kStepsToSleep; ++step) world.step(kStep);
    const std::shared_ptr<const Snapshot> asleep = world.snapshot();
    std::vector<BodyId> bodies = world.bodies();
    std::reverse(bodies.begin(), bodies.end());  // the worst order for a sorted list of awake bodies
    double best = 1e308;
    for (int run = 0; run < kRuns; ++run) {
        world.restore(*asleep);
        best = std::min(best, millisecondsOf([&] {
                            for (const BodyId body : bodies) world.wake(body);
                            world.collide(kStep);
                        }));
    }
    return best;
}

}  // namespace rubble::bench
