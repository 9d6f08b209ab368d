#pragma once

#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

namespace rubble::test {

inline constexpr double kDamLength = 12.0, kDamHeight = 4.0, kDamDepth = 0.5;  // m
inline constexpr double kTowerWidth = 1.2, kTowerHeight = 5.0;                 // m

/// A wall of bricks in English bond, stronger towards its base, whose lowest course is anchored.
inline Asset damWall() {
    Asset asset{.name = "dam",
                .shape = Prism{{rectangle({-kDamLength / 2.0, 0.0}, {kDamLength / 2.0, kDamHeight}), {}}, kDamDepth}};
    asset.breakAs = BreakAs::Bonded;
    asset.bonding.impulsePerArea = 500.0;
    asset.bonding.radius = 0.8;
    asset.bonding.span = 0.5;
    asset.bonding.collapseDelay = 0.3;
    asset.bonding.minimumIsland = 3;
    asset.bonding.heightStrengths = {{0.0, 3.0}, {kDamHeight, 1.0}};
    asset.bonding.strokes = {
        {.brush = BondBrush::Anchor, .radius = 0.1, .points = {{-kDamLength / 2.0, 0.05}, {kDamLength / 2.0, 0.05}}}};
    return asset;
}

inline void addDamShots(Project& project) {
    addShot(project, "ball through the middle", 0.5,
            Throw{.kind = ProjectileKind::Ball,
                  .size = Vec3(0.7),
                  .mass = 500.0,
                  .from = {0.0, 2.3, 10.0},
                  .to = {0.0, 2.2, 0.0},
                  .speed = 28.0});
    addShot(project, "block low at the foot", 0.5,
            Throw{.kind = ProjectileKind::Box,
                  .size = {1.4, 1.0, 1.2},
                  .mass = 4000.0,
                  .from = {-3.2, 1.1, 10.0},
                  .to = {-3.2, 0.8, 0.0},
                  .speed = 22.0});
    addShot(project, "blast at the foot", 0.5, Blast{.at = {0.0, 0.9, 1.2}, .impulse = 30000.0, .radius = 3.5});
}

inline void addDamTests(Project& project) {
    const Id dam = project.instances[0].id, gatehouse = project.instances[3].id;
    const Id ball = project.shots[0].id, blast = project.shots[2].id;
    using enum ExpectationKind;
    addPlayTest(project,
                {.name = "stays intact", .duration = 3.0, .expectations = {{.kind = StandsUntouched, .value = 3.0}}});
    addPlayTest(project, {.name = "a ball makes a hole, and the rest stands",
                          .shots = {ball},
                          .duration = 4.0,
                          .expectations = {{.kind = Breaks, .instance = dam},
                                           {.kind = StandsUntouched, .instance = gatehouse, .value = 4.0}}});
    addPlayTest(project, {.name = "a blast at the foot brings down what it carried",
                          .shots = {blast},
                          .duration = 5.0,
                          .expectations = {{.kind = BreaksIntoAtLeast, .instance = dam, .value = 100.0},
                                           {.kind = NothingAbove, .instance = gatehouse, .value = 3.5}}});
}

/// projects/dam.rubble: a dam of 496 bonded bricks between two towers, with a gatehouse on it.
inline Project dam() {
    Project project;
    const Id masonry = addMaterial(project, {.name = "masonry",
                                             .density = 2200.0,
                                             .friction = 0.6,
                                             .outside = {0.74, 0.64, 0.54},
                                             .inside = {0.84, 0.76, 0.66},
                                             .finish = Finish::Brick});
    const Id granite = addMaterial(project, {.name = "granite",
                                             .density = 2700.0,
                                             .friction = 0.6,
                                             .outside = {0.52, 0.54, 0.57},
                                             .inside = {0.66, 0.68, 0.7},
                                             .finish = Finish::Stone});
    Asset wall = damWall();
    wall.material = masonry;
    const Id damId = addAsset(project, wall,
                              {BrickBond{.bond = BondKind::English,
                                         .length = 0.59,
                                         .width = 0.285,
                                         .height = 0.24,
                                         .mortar = 0.01,
                                         .origin = {-kDamLength / 2.0, 0.0}}});
    const Id tower =
        addAsset(project,
                 {.name = "tower",
                  .material = granite,
                  .shape = Prism{{rectangle({-kTowerWidth / 2.0, 0.0}, {kTowerWidth / 2.0, kTowerHeight}), {}}, 1.4},
                  .threshold = 50000.0},
                 {BlueNoise{.minimumDistance = 0.3, .count = 40}, LloydRelaxation{.rounds = 2}});
    const Id gatehouse = addAsset(project,
                                  {.name = "gatehouse",
                                   .material = granite,
                                   .shape = Prism{{rectangle({-0.7, 0.0}, {0.7, 1.2}), {}}, 0.6},
                                   .threshold = 20000.0},
                                  {BlueNoise{.minimumDistance = 0.2, .count = 20}, LloydRelaxation{.rounds = 2}});
    const double side = (kDamLength + kTowerWidth) / 2.0;
    addInstance(project, damId, "dam", {.position = {0.0, 0.0, 0.0}});
    addInstance(project, tower, "left tower", {.position = {-side, 0.0, 0.0}});
    addInstance(project, tower, "right tower", {.position = {side, 0.0, 0.0}});
    addInstance(project, gatehouse, "gatehouse", {.position = {0.0, kDamHeight, 0.0}});
    for (const std::size_t k : {1, 2}) project.instances[k].isFixed = true;
    addDamShots(project);
    addDamTests(project);
    return project;
}

}  // namespace rubble::test
