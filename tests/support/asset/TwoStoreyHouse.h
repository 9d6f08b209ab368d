#pragma once

#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace rubble::test {

// A house of 8 m (x) by 6 m (z) whose gables face front (+z) and back. Where its right front corner would be on the
// ground floor is a porch: a pier carries the corner of the storey above. All parts are bonded, and joined by mortar.
inline constexpr double kHouseWall = 0.3, kHouseStorey = 2.5, kHouseFloor = 0.2;  // m
inline constexpr double kHouseHalfWidth = 4.0, kHouseHalfDepth = 3.0;             // m, to the outer faces
inline constexpr double kHouseRise = 3.0;                                         // m, of the gables: 3 : 4 : 5
inline constexpr double kHousePorch = -1.0, kHouseMiddle = -1.2;                  // x and z at which it begins, m
inline constexpr double kHousePier = 0.4;                                         // m, its sides

/// A wall from its base, y = 0, around x = 0. Doors are [left, right] of notches from below.
inline Polygon wallOutline(double width, std::vector<std::pair<double, double>> doors, std::vector<Box2> windows) {
    constexpr double kDoorHeight = 2.05;
    Polygon outline{{{-width / 2.0, 0.0}}, {}};
    for (const auto& [left, right] : doors)
        outline.outer.insert(outline.outer.end(),
                             {{left, 0.0}, {left, kDoorHeight}, {right, kDoorHeight}, {right, 0.0}});
    outline.outer.insert(outline.outer.end(),
                         {{width / 2.0, 0.0}, {width / 2.0, kHouseStorey}, {-width / 2.0, kHouseStorey}});
    for (const Box2& window : windows) outline.holes.push_back(reversed(rectangle(window.min, window.max)));
    return outline;
}

inline Polygon gableOutline() {
    constexpr double kHalf = kHouseHalfWidth;
    return {
        {{-kHalf, 0.0}, {kHalf, 0.0}, {kHalf, kHouseStorey}, {0.0, kHouseStorey + kHouseRise}, {-kHalf, kHouseStorey}},
        {reversed(rectangle({-2.5, 0.8}, {-1.5, 2.0})), reversed(rectangle({1.5, 0.8}, {2.5, 2.0})),
         reversed(rectangle({-0.5, 2.9}, {0.5, 3.9}))}};
}

/// Adds the parts of the house to a project.
class HouseBuilder {
public:
    /// `density`: fragments per m² of the faces of walls, floor and roof.
    HouseBuilder(Project& project, double density) : m_project(project), m_density(density) {
        m_plaster = addMaterial(project, {.name = "plaster",
                                          .density = 1800.0,
                                          .friction = 0.8,
                                          .outside = {0.93, 0.88, 0.76},
                                          .inside = {0.70, 0.42, 0.32},
                                          .finish = Finish::Plaster});
        m_concrete = addMaterial(project, {.name = "concrete",
                                           .density = 2400.0,
                                           .friction = 0.7,
                                           .outside = {0.66, 0.66, 0.65},
                                           .inside = {0.56, 0.54, 0.50},
                                           .finish = Finish::Concrete});
        m_tiles = addMaterial(project, {.name = "tiles",
                                        .density = 1200.0,
                                        .friction = 0.8,
                                        .outside = {0.68, 0.24, 0.17},
                                        .inside = {0.55, 0.33, 0.25},
                                        .finish = Finish::Tiles});
    }

    void addGroundFloor() {
        const Box2 left{{-1.1, 0.8}, {-0.2, 2.0}}, right{{0.2, 0.8}, {1.1, 2.0}};
        const Box2 farLeft{{-2.5, 0.8}, {-1.5, 2.0}}, farRight{{1.5, 0.8}, {2.5, 2.0}};
        const Id front = wall("front wall", wallOutline(kX + kHousePorch, {}, {left, right}));
        const Id back = wall("back wall", wallOutline(2.0 * kX, {{-0.5, 0.5}}, {farLeft, farRight}));
        const Id middle = wall("middle wall", wallOutline(2.0 * kX - kHouseWall * 2.0, {{-2.8, -1.9}, {1.0, 1.9}}, {}));
        const Id porch = wall("porch wall", wallOutline(kInnerFront - kPorchBack, {}, {}));
        const Id shortSide = wall("short side wall", wallOutline(kPorchBack + kInnerFront, {}, {}));
        const Id pier =
            asset("pier", m_concrete, {rectangle({-kHousePier / 2.0, 0.0}, {kHousePier / 2.0, kHouseStorey}), {}},
                  kHousePier, kWalls);
        m_side = wall("side wall", wallOutline(2.0 * kInnerFront, {}, {{{-0.5, 0.8}, {0.5, 2.0}}}));

        instance(front, "front", {.position = {(kHousePorch - kX) / 2.0, 0.0, kZ - kHalfWall}});
        instance(back, "back", {.position = {0.0, 0.0, kHalfWall - kZ}});
        instance(m_side, "left", {{kHalfWall - kX, 0.0, 0.0}, kTurned});
        instance(middle, "middle", {.position = {0.0, 0.0, kHouseMiddle}});
        instance(porch, "porch", {{kHousePorch - kHalfWall, 0.0, (kInnerFront + kPorchBack) / 2.0}, kTurned});
        instance(shortSide, "right", {{kX - kHalfWall, 0.0, (kPorchBack - kInnerFront) / 2.0}, kTurned});
        instance(pier, "pier", {.position = {kX - kHousePier / 2.0, 0.0, kZ - kHousePier / 2.0}});
    }

    void addUpperFloor() {
        constexpr double kUpper = kHouseStorey + kHouseFloor;
        const Quat laid{std::numbers::sqrt2 / 2.0, -std::numbers::sqrt2 / 2.0, 0.0, 0.0};  // y to -z, z to y
        const Id floor = asset("floor", m_concrete, {rectangle({-kX, -kZ}, {kX, kZ}), {}}, kHouseFloor, kFloors);
        const Id gable = wall("gable", gableOutline());
        instance(floor, "floor", {{0.0, kHouseStorey + kHouseFloor / 2.0, 0.0}, laid});
        instance(gable, "front gable", {.position = {0.0, kUpper, kZ - kHalfWall}});
        instance(gable, "back gable", {.position = {0.0, kUpper, kHalfWall - kZ}}, 1);
        instance(m_side, "upper left", {{kHalfWall - kX, kUpper, 0.0}, kTurned}, 1);
        instance(m_side, "upper right", {{kX - kHalfWall, kUpper, 0.0}, kTurned}, 2);
    }

    void addRoof() {
        constexpr double kSlope = 5.6, kThick = 0.2;  // m, from ridge to eaves: 5 m of it above the gables
        constexpr double kRidge = 2.0 * kHouseStorey + kHouseFloor + kHouseRise;
        const Vec2 half{kSlope / 2.0, kZ + 0.4};
        const Id roof = asset("roof", m_tiles, {rectangle(-half, half), {}}, kThick, kRoofs);
        const double w = std::sqrt(1.8) / 2.0, z = 0.6 / (4.0 * w);  // of the slope: cosine 0.8, sine 0.6
        const Quat right{w, -w, z, -z}, halfTurn{0.0, 0.0, 1.0, 0.0};
        const Vec3 middle{0.4 * kSlope + 0.3 * kThick, kRidge - 0.3 * kSlope + 0.4 * kThick, 0.0};
        instance(roof, "roof right", {middle, right});
        instance(roof, "roof left", {{-middle.x, middle.y, 0.0}, halfTurn * right}, 1);
    }

private:
    static constexpr double kX = kHouseHalfWidth, kZ = kHouseHalfDepth, kHalfWall = kHouseWall / 2.0;
    static constexpr double kInnerFront = kZ - kHouseWall, kPorchBack = kHouseMiddle + kHalfWall;
    static constexpr Quat kTurned{std::numbers::sqrt2 / 2.0, 0.0, std::numbers::sqrt2 / 2.0, 0.0};  // x to -z, z to x
    static inline const Bonding kWalls{
        .impulsePerArea = 500.0, .radius = 0.6, .span = 0.5, .collapseDelay = 0.25, .minimumIsland = 3};
    static inline const Bonding kFloors{
        .impulsePerArea = 1000.0, .radius = 0.6, .span = 2.6, .collapseDelay = 0.2, .minimumIsland = 3};
    static inline const Bonding kRoofs{
        .impulsePerArea = 300.0, .radius = 0.6, .span = 3.2, .collapseDelay = 0.3, .minimumIsland = 3};

    Id wall(const std::string& name, const Polygon& outline) {
        return asset(name, m_plaster, outline, kHouseWall, kWalls);
    }
    Id asset(const std::string& name, Id material, const Polygon& outline, double depth, const Bonding& bonding) {
        Asset asset{.name = name, .material = material, .shape = Prism{outline, depth}};
        asset.breakAs = BreakAs::Bonded;
        asset.bonding = bonding;
        double area = signedArea(outline.outer);
        for (const Ring& hole : outline.holes) area += signedArea(hole);
        const auto count = std::max(10u, static_cast<std::uint32_t>(std::lround(m_density * area)));
        return addAsset(m_project, asset, {UniformScatter{.count = count}, LloydRelaxation{.rounds = 3}});
    }
    void instance(Id asset, const std::string& name, const Pose& pose, std::uint32_t variant = 0) {
        addInstance(m_project, asset, name, pose);
        m_project.instances.back().variant = variant;
        m_project.instances.back().isAnchored = pose.position.y == 0.0;
    }

    Project& m_project;
    double m_density;
    Id m_plaster = 0, m_concrete = 0, m_tiles = 0;
    Id m_side = 0;  // the wall of the left side, and of both above
};

/// Shots that make holes, or take away what carries a corner.
inline void addHouseShots(Project& project) {
    constexpr double kTime = 0.5;  // s: before it the house must stand
    addShot(project, "ball at the front wall", kTime,
            Throw{.kind = ProjectileKind::Ball,
                  .size = Vec3(0.6),
                  .mass = 600.0,
                  .from = {-2.0, 2.2, 14.0},
                  .to = {-2.0, 1.5, 3.0},
                  .speed = 25.0});
    addShot(project, "block at the pier", kTime,
            Throw{.size = Vec3(0.9), .mass = 1500.0, .from = {14.0, 1.7, 2.8}, .to = {4.0, 1.2, 2.8}, .speed = 22.0});
    addShot(project, "ball through the roof", kTime,
            Throw{.kind = ProjectileKind::Ball,
                  .size = Vec3(0.7),
                  .mass = 800.0,
                  .from = {6.0, 16.0, 5.0},
                  .to = {2.0, 6.7, 0.0},
                  .speed = 25.0});
    addShot(project, "blast in the porch", kTime, Blast{.at = {1.0, 1.2, 1.5}, .impulse = 8000.0, .radius = 4.0});
}

inline void addHouseTests(Project& project) {
    const auto idOf = [&](const char* name) { return std::ranges::find(project.instances, name, &Instance::name)->id; };
    const auto stands = [&](const char* name) {
        return Expectation{.kind = ExpectationKind::StandsUntouched, .instance = idOf(name), .value = 5.0};
    };
    const auto breaks = [&](const char* name) {
        return Expectation{.kind = ExpectationKind::Breaks, .instance = idOf(name)};
    };
    const auto breaksInto = [&](const char* name, double count) {
        return Expectation{.kind = ExpectationKind::BreaksIntoAtLeast, .instance = idOf(name), .value = count};
    };
    const auto staysUp = [&](const char* name, double lost) {
        return Expectation{.kind = ExpectationKind::StaysUp, .instance = idOf(name), .value = lost};
    };
    const auto hole = [&](const char* name, double width) {
        return Expectation{.kind = ExpectationKind::HoleAtMost, .instance = idOf(name), .value = width};
    };
    const auto add = [&](const char* name, std::vector<std::size_t> shots, std::vector<Expectation> expectations) {
        PlayTest test{.name = name, .duration = 5.0, .expectations = std::move(expectations)};
        for (const std::size_t shot : shots) test.shots.push_back(project.shots[shot].id);
        addPlayTest(project, std::move(test));
    };
    add("the house stands", {}, {{.kind = ExpectationKind::StandsUntouched, .value = 5.0}});
    add("a ball makes a hole in the front wall, and the house stands", {0},
        {breaks("front"), hole("front", 2.0), staysUp("floor", 0.0), stands("front gable"), stands("roof left")});
    add("without its pier the corner comes down, and the rest stands", {1},
        {breaksInto("floor", 20.0), breaksInto("front gable", 10.0), stands("middle"), stands("back gable"),
         stands("roof left")});
    add("a ball goes through the roof, and the walls stand", {2},
        {breaks("roof right"), hole("roof right", 2.0), staysUp("front gable", 0.01), stands("roof left")});
    add("a blast in the porch brings down the front", {3},
        {breaksInto("front gable", 100.0), breaksInto("floor", 100.0), staysUp("back", 0.02), stands("back gable")});
    add("the rest stays up when the pier is gone", {}, {staysUp("floor", 0.1), staysUp("front gable", 0.1)});
    project.playTests.back().removed = {{idOf("pier"), {}}};
    project.playTests.back().expectations.push_back(staysUp("roof right", 0.0));
}

/// projects/two-storey-house.rubble; with another `density`, see HouseBuilder, the same house of more or fewer
/// fragments.
inline Project twoStoreyHouse(double density = 8.0) {
    Project project;
    project.ground.friction = 0.8;
    HouseBuilder house(project, density);
    house.addGroundFloor();
    house.addUpperFloor();
    house.addRoof();
    project.mortars = {{.id = project.nextId++, .name = "mortar"}};
    addHouseShots(project);
    addHouseTests(project);
    return project;
}

}  // namespace rubble::test
