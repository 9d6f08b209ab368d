#pragma once

#include "core/base/math/Trigonometry.h"
#include "tests/support/asset/ProjectParts.h"

#include <numbers>

namespace rubble::test {

inline constexpr double kArchRadius = 1.5, kPierWidth = 0.75, kSpringing = 2.0, kArcadeHeight = 4.5;  // m
inline constexpr int kArches = 3;

/// The outline of an arcade from its left end, x = 0, on four piers.
inline Polygon arcadeOutline() {
    constexpr int kSides = 12;  // of each arch
    Polygon outline;
    double x = 0.0;
    for (int arch = 0; arch < kArches; ++arch) {
        outline.outer.push_back({x, 0.0});
        outline.outer.push_back({x + kPierWidth, 0.0});
        const Vec2 centre{x + kPierWidth + kArchRadius, kSpringing};
        for (int k = 0; k <= kSides; ++k) {
            const double angle = std::numbers::pi * (1.0 - static_cast<double>(k) / kSides);
            outline.outer.push_back(centre + kArchRadius * Vec2(cosine(angle), sine(angle)));
        }
        x += kPierWidth + 2.0 * kArchRadius;
    }
    outline.outer.push_back({x, 0.0});
    outline.outer.push_back({x + kPierWidth, 0.0});
    outline.outer.push_back({x + kPierWidth, kArcadeHeight});
    outline.outer.push_back({0.0, kArcadeHeight});
    const double middle = (x + kPierWidth) / 2.0;
    for (Vec2& point : outline.outer) point.x -= middle;
    return outline;
}

/// projects/arcade.rubble: three arches of sandstone in one bonded wall, that stand on their piers.
inline Project arcade() {
    Project project;
    const Id stone = addMaterial(project, {.name = "sandstone",
                                           .density = 2200.0,
                                           .friction = 0.6,
                                           .outside = {0.80, 0.70, 0.55},
                                           .inside = {0.88, 0.80, 0.66},
                                           .finish = Finish::Stone});
    Asset asset{.name = "arcade", .material = stone, .shape = Prism{arcadeOutline(), 0.5}};
    asset.breakAs = BreakAs::Bonded;
    asset.bonding.impulsePerArea = 400.0;
    asset.bonding.radius = 0.5;
    asset.bonding.span = 0.7;
    asset.bonding.collapseDelay = 0.3;
    asset.bonding.minimumIsland = 4;
    const Id id =
        addAsset(project, asset, {BlueNoise{.minimumDistance = 0.22, .count = 420}, LloydRelaxation{.rounds = 2}});
    addInstance(project, id, "arcade", {.position = {0.0, 0.0, 0.0}});
    project.instances[0].isAnchored = true;
    addShot(project, "blast at a pier", 0.5, Blast{.at = {-1.875, 0.9, 0.7}, .impulse = 3000.0, .radius = 1.6});
    addShot(project, "ball at a spandrel", 0.5,
            Throw{.kind = ProjectileKind::Ball,
                  .size = Vec3(0.5),
                  .mass = 150.0,
                  .from = {1.875, 3.6, 9.0},
                  .to = {1.875, 3.6, 0.0},
                  .speed = 22.0});
    addPlayTest(project, {.name = "stands",
                          .duration = 3.0,
                          .expectations = {{.kind = ExpectationKind::StandsUntouched, .value = 3.0}}});
    return project;
}

}  // namespace rubble::test
