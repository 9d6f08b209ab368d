#pragma once

#include "core/base/math/Trigonometry.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

#include <numbers>

namespace rubble::test {

inline constexpr std::uint32_t kPanePieces = 200;

/// Seeds on rings around a point of impact, denser towards it: seven rings of twelve, each rotated by half a step from
/// the one before, and one in the centre.
inline PlacedSeeds impactSeeds(Vec2 centre) {
    constexpr std::uint32_t kRings = 7;
    constexpr std::uint32_t kRays = 12;
    PlacedSeeds placed{{{.index = 0, .position = centre}}};
    double radius = 0.03;  // m
    for (std::uint32_t ring = 0; ring < kRings; ++ring, radius *= 1.45) {
        for (std::uint32_t ray = 0; ray < kRays; ++ray) {
            const double angle = (ray + 0.5 * (ring % 2)) * 2.0 * std::numbers::pi / kRays;
            const Vec2 position = centre + radius * Vec2(cosine(angle), sine(angle));
            placed.seeds.push_back({.index = ring * kRays + ray + 1, .position = position});
        }
    }
    return placed;
}

/// projects/pane.rubble: a fixed window pane with 200 fragments, fine near a point and coarse elsewhere, that cracks
/// where it is hit in play.
inline Project pane() {
    Project project;
    const Id glass = addMaterial(project, {.name = "glass",
                                           .density = 2500.0,
                                           .friction = 0.4,
                                           .restitution = 0.2,
                                           .outside = {0.75, 0.88, 0.9},
                                           .inside = {0.55, 0.78, 0.74},
                                           .opacity = 0.3,
                                           .finish = Finish::Glass});
    const PlacedSeeds impact = impactSeeds({-0.125, 0.1875});
    const auto others = kPanePieces - static_cast<std::uint32_t>(impact.seeds.size());
    const Asset asset{.name = "pane",
                      .material = glass,
                      .shape = Prism{{rectangle({-0.625, -0.75}, {0.625, 0.75}), {}}, 0.006},
                      .threshold = 15.0,
                      .cutAtImpact = CutAtImpact{.fragments = kPanePieces, .falloffRadius = 0.3}};
    const Id id = addAsset(project, asset,
                           {impact, BlueNoise{.minimumDistance = 0.08, .count = others}, LloydRelaxation{.rounds = 2}});
    addInstance(project, id, "pane", {.position = {0.0, 1.75, 0.0}});
    project.instances[0].isFixed = true;
    addShot(project, "ball at the edge", 0.1,
            Throw{.kind = ProjectileKind::Ball,
                  .size = {0.1, 0.1, 0.1},
                  .mass = 1.5,
                  .from = {0.45, 2.2, 4.0},
                  .to = {0.45, 2.2, 0.0},
                  .speed = 15.0});
    return project;
}

}  // namespace rubble::test
