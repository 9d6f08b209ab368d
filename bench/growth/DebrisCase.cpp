#include "bench/Timing.h"
#include "bench/growth/GrowthCases.h"
#include "core/play/session/Session.h"

#include <cmath>

namespace rubble::bench {

/// A floating block with n fragments whose debris fades out in the measured step.
double debrisCase(std::size_t n) {
    constexpr double kStep = 1.0 / 60.0;
    const auto side = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n))));
    const double size = side;
    Project project;
    project.materials = {{.id = 1, .name = "stone"}};
    Asset asset{.id = 2, .name = "block", .material = 1};
    asset.shape = Prism{{{{0.0, 0.0}, {size, 0.0}, {size, size}, {0.0, size}}, {}}, 0.5};
    PlacedSeeds cells;
    for (std::uint32_t k = 0; k < side * side; ++k) {
        cells.seeds.push_back({k, {0.5 + static_cast<double>(k % side), 0.5 + static_cast<double>(k / side)}});
    }
    asset.pattern.layers = {{.id = 3, .parameters = std::move(cells)}};
    project.assets = {asset};
    project.instances = {{.id = 4, .name = "block", .asset = 2}};
    project.nextId = 5;
    project.ground.isOn = false;
    project.gravity = Vec3(0.0);
    project.debris = {.lifetime = 1.5 * kStep, .fade = 0.0, .maxFragments = 1'000'000};
    Session session = Session::start(playScene(project).value(), {.dt = kStep}).value();
    static_cast<void>(session.add(BreakInput{session.bodies()[0].number}));
    session.step();
    return millisecondsOf([&] { session.step(); });
}

}  // namespace rubble::bench
