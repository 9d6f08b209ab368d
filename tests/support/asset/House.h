#pragma once

#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace rubble::test {

// The house of the thesis: 5 m wide (x), 6 m long (z), its ridge along z at x = 0. Four courses of 20 wall blocks less
// nine openings, two gables, four roof panels: 77 bodies. Blocks touch exactly: their coordinates are multiples of 1/4
// m and their quaternions consist of halves, so that nothing is rounded.
inline constexpr double kGableBase = 5.0;      // m
inline constexpr double kGableSide = 2.89;     // m
inline constexpr double kWallHeight = 4.0;     // m
inline constexpr double kHalfLength = 3.0;     // m, to the outer face of a gable
inline constexpr double kRoofSlope = 3.5;      // m, from ridge to eaves
inline constexpr double kRoofAlong = 3.0;      // m, half the ridge
inline constexpr double kRoofDepth = 0.25;     // m
inline constexpr double kWallThickness = 0.5;  // m

/// The distance of the roof panels from their supports and from each other, m: invisible, and a hundred times the
/// rounding of the panels' corners, since the slope is not exactly representable.
inline constexpr double kRoofGap = 0x1p-40;

inline double gableHeight() { return std::sqrt(kGableSide * kGableSide - kGableBase * kGableBase / 4.0); }

/// A wall of the house: columns of blocks, five per course.
struct WallRow {
    std::string name;
    Vec3 first;                         // centre of the lowest block of the first column
    Vec3 step;                          // from column to column
    Quat orientation;                   // of a block
    std::array<int, 5> blocksInColumn;  // missing ones are openings, always at the top
};

/// One of the four rotations that map a block to itself, so that neighbours fracture differently.
inline Quat halfTurn(int number) {
    constexpr std::array<std::array<double, 4>, 4> kTurns = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
    const auto& [w, x, y, z] = kTurns[static_cast<std::size_t>(number % 4)];
    return {w, x, y, z};
}

inline void addWall(Project& project, Id asset, const WallRow& row) {
    for (int column = 0; column < 5; ++column) {
        for (int course = 0; course < row.blocksInColumn[static_cast<std::size_t>(column)]; ++course) {
            const Vec3 position = row.first + static_cast<double>(column) * row.step + Vec3(0.0, course, 0.0);
            const std::string name = row.name + ' ' + std::to_string(column + 1) + '.' + std::to_string(course + 1);
            addInstance(project, asset, name, {position, row.orientation * halfTurn(3 * column + 2 * course)});
        }
    }
}

inline void addWalls(Project& project, Id wall) {
    const Quat straight{1.0, 0.0, 0.0, 0.0};
    const Quat across{0.5, 0.5, 0.5, 0.5};  // x to y, y to z, z to x: the depth goes to x, and every bit is exact
    const double front = kHalfLength - kWallThickness / 2.0;
    const double side = kGableBase / 2.0 - kWallThickness / 2.0;
    addWall(project, wall, {"front", {-2.0, 0.5, front}, {1, 0, 0}, straight, {4, 4, 0, 4, 4}});  // a door
    addWall(project, wall, {"back", {-2.0, 0.5, -front}, {1, 0, 0}, straight, {4, 4, 3, 4, 4}});  // a window
    addWall(project, wall, {"left", {-side, 0.5, -2.0}, {0, 0, 1}, across, {4, 3, 4, 3, 4}});     // two windows
    addWall(project, wall, {"right", {side, 0.5, -2.0}, {0, 0, 1}, across, {4, 3, 4, 3, 4}});     // two windows
}

/// A panel on the slope towards +x, or towards -x; its local x runs from ridge to eaves, its local z out of the roof.
inline Pose panelPose(double side, double alongRidge) {
    const double length = std::sqrt(gableHeight() * gableHeight() + kGableBase * kGableBase / 4.0);
    const double cosine = kGableBase / 2.0 / length;
    const double sine = gableHeight() / length;
    const double above = kRoofDepth / 2.0 + kRoofGap;
    const Vec3 position{side * (cosine * kRoofSlope / 2.0 + sine * above),
                        kWallHeight + gableHeight() - sine * kRoofSlope / 2.0 + cosine * above, alongRidge};
    // A rotation by 90 degrees about x lays the panel flat; then the slope rotates it about z by an angle with a known
    // cosine.
    const double w = std::sqrt((1.0 + cosine) / 4.0);
    const double z = sine / (4.0 * w);
    const Quat right{w, -w, z, -z};
    return {position, side > 0.0 ? right : Quat{0.0, 0.0, 1.0, 0.0} * right};
}

inline void addRoof(Project& project, Id roof) {
    const double middle = kRoofAlong / 2.0 + kRoofGap;
    addInstance(project, roof, "roof front left", panelPose(-1.0, middle));
    addInstance(project, roof, "roof front right", panelPose(1.0, middle));
    addInstance(project, roof, "roof back left", panelPose(-1.0, -middle));
    addInstance(project, roof, "roof back right", panelPose(1.0, -middle));
}

/// Relaxed seeds, so that their cells have similar sizes.
inline std::vector<LayerParameters> evenSeeds(std::uint32_t count) {
    return {UniformScatter{.count = count}, LloydRelaxation{.rounds = 3}};
}

/// The strength requirements of walls, gables and roof.
inline void addIntents(Project& project) {
    const auto survives = [](const HitRequirement& hit) {
        return StrengthRequirement{RequirementOutcome::Survives, hit};
    };
    const StrengthRequirement breaksWhenDropped{RequirementOutcome::Breaks, DropRequirement{.height = 0.5}};
    const std::array<HitRequirement, 3> survived{{{.mass = 40.0, .speed = 14.0},  // the ball at the gable
                                                  {.mass = 40.0, .speed = 14.0},
                                                  {.mass = 100.0, .speed = 15.0}}};  // other debris
    for (std::size_t k = 0; k < survived.size(); ++k) {
        project.assets[k].requirements = {survives(survived[k]), breaksWhenDropped};
    }
}

/// Shots that break a few blocks, bring the roof down, or break nothing; with their play-tests.
inline void addShots(Project& project) {
    constexpr double kTime = 0.5;  // s: before it the house must stand
    const Id box =
        addShot(project, "box at the door", kTime,
                Throw{.size = Vec3(0.6), .mass = 200.0, .from = {3.5, 2.4, 9.0}, .to = {1.0, 1.6, 3.0}, .speed = 22.0});
    const Id block = addShot(
        project, "block under the roof", kTime,
        Throw{.size = Vec3(1.4), .mass = 1500.0, .from = {-8.0, 2.2, 0.5}, .to = {-2.5, 1.9, 0.5}, .speed = 38.0});
    const Id ball = addShot(project, "ball at the gable", kTime,
                            Throw{.kind = ProjectileKind::Ball,
                                  .size = Vec3(0.4),
                                  .mass = 40.0,
                                  .from = {-1.0, 5.4, 9.0},
                                  .to = {-0.6, 4.5, 3.0},
                                  .speed = 14.0});
    const auto idOf = [&](const std::string& name) {
        for (const Instance& instance : project.instances) {
            if (instance.name == name) return instance.id;
        }
        return Id{0};
    };
    using enum ExpectationKind;
    addPlayTest(project, {.name = "the house stands", .duration = 10.0, .expectations = {{StandsUntouched, 0, 10.0}}});
    addPlayTest(project, {.name = "a box breaks the wall beside the door",
                          .shots = {box},
                          .duration = 5.0,
                          .expectations = {{BreaksIntoAtLeast, idOf("front 4.1"), 4.0},
                                           {Breaks, idOf("front 4.2"), 0.0},
                                           {DoesNotBreak, idOf("front gable"), 0.0},
                                           {NothingFaster, 0, 0.5}}});
    addPlayTest(project, {.name = "a block brings the roof down",
                          .shots = {block},
                          .duration = 8.0,
                          .expectations = {{Breaks, idOf("roof front right"), 0.0},
                                           {NothingAbove, idOf("roof front left"), 4.5}}});
    addPlayTest(project, {.name = "a ball only rattles",
                          .shots = {ball},
                          .duration = 5.0,
                          .expectations = {{DoesNotBreak, 0, 0.0}, {StandsUntouched, idOf("roof back left"), 5.0}}});
}

/// projects/house.rubble
inline Project house() {
    Project project;
    const Id plaster = addMaterial(project, {.name = "yellow masonry",
                                             .density = 1800.0,
                                             .friction = 0.8,
                                             .outside = {0.93, 0.77, 0.36},
                                             .inside = {0.76, 0.66, 0.5},
                                             .finish = Finish::Brick});
    const Id tiles = addMaterial(project, {.name = "red tiles",
                                           .density = 1200.0,
                                           .friction = 0.8,
                                           .outside = {0.72, 0.2, 0.15},
                                           .inside = {0.58, 0.33, 0.26},
                                           .finish = Finish::Tiles});
    const Prism wallPrism{{rectangle({-0.5, -0.5}, {0.5, 0.5}), {}}, kWallThickness};
    const Prism gablePrism{{{{-kGableBase / 2.0, 0.0}, {kGableBase / 2.0, 0.0}, {0.0, gableHeight()}}, {}},
                           kWallThickness};
    const Vec2 half{kRoofSlope / 2.0, kRoofAlong / 2.0};
    const Prism roofPrism{{rectangle(-half, half), {}}, kRoofDepth};
    const Id wall =
        addAsset(project, {.name = "wall", .material = plaster, .shape = wallPrism, .threshold = 900.0}, evenSeeds(4));
    const Id gable = addAsset(project, {.name = "gable", .material = plaster, .shape = gablePrism, .threshold = 2500.0},
                              evenSeeds(7));
    const Id roof =
        addAsset(project, {.name = "roof", .material = tiles, .shape = roofPrism, .threshold = 2000.0}, evenSeeds(9));

    addIntents(project);
    addWalls(project, wall);
    const double front = kHalfLength - kWallThickness / 2.0;
    addInstance(project, gable, "front gable", {.position = {0.0, kWallHeight, front}});
    addInstance(project, gable, "back gable", {.position = {0.0, kWallHeight, -front}});
    addRoof(project, roof);
    addShots(project);
    project.ground.friction = 0.8;
    return project;
}

/// projects/joined-house.rubble: the same house as one structure. Its blocks are bonded and joined by mortar, and stand
/// on the ground.
inline Project joinedHouse() {
    Project project = house();
    for (Asset& asset : project.assets) {
        asset.breakAs = BreakAs::Bonded;
        asset.bonding.impulsePerArea = 400.0;
        asset.requirements.clear();
    }
    for (Instance& instance : project.instances) instance.isAnchored = true;
    project.mortars = {{.id = project.nextId++, .name = "mortar"}};
    project.playTests.clear();
    const auto idOf = [&](const char* name) { return std::ranges::find(project.instances, name, &Instance::name)->id; };
    using enum ExpectationKind;
    addPlayTest(project, {.name = "the house stands", .duration = 10.0, .expectations = {{StandsUntouched, 0, 10.0}}});
    addPlayTest(project, {.name = "a box makes a hole beside the door",
                          .shots = {project.shots[0].id},
                          .duration = 5.0,
                          .expectations = {{Breaks, idOf("front 4.1"), 0.0},
                                           {StandsUntouched, idOf("front gable"), 5.0},
                                           {StandsUntouched, idOf("roof front right"), 5.0}}});
    addPlayTest(project, {.name = "a block goes through the wall, and the roof stands",
                          .shots = {project.shots[1].id},
                          .duration = 8.0,
                          .expectations = {{Breaks, idOf("left 3.2"), 0.0},
                                           {StandsUntouched, idOf("roof front left"), 8.0},
                                           {StandsUntouched, idOf("back gable"), 8.0}}});
    return project;
}

}  // namespace rubble::test
