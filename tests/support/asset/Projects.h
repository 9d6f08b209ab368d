#pragma once

#include "core/asset/project/Project.h"
#include "tests/support/asset/Bonds.h"
#include "tests/support/fracture/PatternSamples.h"
#include "tests/support/geometry/Outlines.h"

#include <limits>
#include <memory>

namespace rubble {

/// A box of 1 x 1 x 0.5 m of material 1 with the seeds of one layer.
inline Asset boxAsset(Id id, Id layer, LayerParameters parameters) {
    Asset asset{.id = id, .name = "box", .material = 1};
    asset.shape = Prism{unitSquare(), 0.5};
    asset.pattern.layers = {{.id = layer, .randomSeed = 7, .parameters = std::move(parameters)}};
    return asset;
}

/// A project with one such box, asset 2, with the seeds of layer 3, and instance 10 of it.
inline Project boxProject(LayerParameters parameters) {
    Project project;
    project.nextId = 100;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {boxAsset(2, 3, std::move(parameters))};
    project.instances = {{.id = 10, .name = "wall", .asset = 2}};
    return project;
}

/// Levels, and layers of every kind, in which no member has its default value.
inline Asset layeredWall() {
    Asset wall{.id = 3, .name = "wall", .material = 1};
    wall.shape = Prism{squareRing(), 0.25};
    wall.pattern.layers = {
        {.id = 4,
         .randomSeed = ~std::uint64_t{0},
         .parameters = UniformScatter{.count = 7, .domain = ScatterDomain::BoundingBox},
         .overrides = {{.index = 1, .position = {0.25, -1e-300}}, {.index = 4, .isDeleted = true}}},
        {.id = 5, .isOn = false, .parameters = BlueNoise{0.2, 12, ScatterDomain::BoundingBox}},
        {.id = 6, .randomSeed = 9007199254740993u, .parameters = PlacedSeeds{{{0, {0.1, 0.2}}, {5, {3.5, 3.5}}}}},
        {.id = 7, .parameters = LloydRelaxation{4}}};
    wall.levels = {{.pattern = {{{.id = 8, .parameters = BlueNoise{}}}},
                    .minimumVolume = 1e-3,
                    .threshold = 17.25,
                    .bondStrength = 0.75},
                   {}};
    wall.levels[1].pattern.layers = {
        {.id = 13, .parameters = UniformScatter{.count = {CountBy::Density, 8.0}}},
        {.id = 14, .parameters = BlueNoise{.count = {CountBy::FragmentSize, 0.35}}},
        {.id = 15, .parameters = JitteredGrid{GridCells::Size, 4, 3, 0.5, 0.3, 0.25, ScatterDomain::BoundingBox}},
        {.id = 16, .parameters = Clusters{3, 5, 0.2}},
        {.id = 17, .parameters = RadialPattern{{0.05, -0.1}, 0.9, 3, 5, 1.25, -0.5, 0.75}},
        {.id = 18, .parameters = ImpactScatter{{0.2, 0.1}, 15, 0.05, 3.5}},
        {.id = 19, .parameters = DensityImage{14, DenseWhere::Bright, fourPixels()}},
        {.id = 28, .parameters = BrickBond{BondKind::Flemish, 0.4, 0.2, 0.25, 0.02, {0.1, -0.2}}},
        {.id = 29, .parameters = Slices{7, -0.4, 0.75, 0.125}},
        {.id = 36,
         .parameters = CrackLines{{{2, {{-2.0, 0.1}, {0.0, 0.05}, {2.0, -0.2}}}, {5, {{0.1, -2.0}, {-0.1, 2.0}}}}}},
        {.id = 37, .parameters = Grain{0.7, 4.0}},
        {.id = 38, .parameters = WeightedLloyd{2}}};
    return wall;
}

/// The same with everything else that an asset has.
inline Asset fullWall() {
    Asset wall = layeredWall();
    wall.shaping = {.smallPieces = {SmallPieceRule::Merge, PieceMeasure::FractionOfWhole, 0.01},
                    .gap = 1.0 / 512.0,
                    .roughness = {.amplitude = 0.003, .frequency = 12.5, .octaves = 4, .randomSeed = 77}};
    wall.fragmentLevels = {
        {.fragment = "4.3.1", .level = {}},
        {.fragment = "6.0",
         .level = Level{.pattern = {{{.id = 22, .parameters = UniformScatter{.count = 3}}}}, .minimumVolume = 1e-4}}};
    wall.fragmentThresholds = {{"4.3.1", 2.5}, {"6.0", 1.0 / 3.0}};
    wall.edits = {FragmentMerge{.into = "4.2", .merged = {"6.5", "4.6"}},
                  FragmentSplit{.fragment = "4.2/8.1", .line = {{0.1, -2.5}, {1.0, 1.0 / 3.0}}}};
    wall.insideMaterial = 2;
    wall.threshold = 55.5;
    wall.contactTime = 0.00125;
    wall.insideUvScale = 2.0;
    wall.cutAtImpact = {.fragments = 17, .falloffRadius = 0.45};
    wall.breakAs = BreakAs::Bonded;
    wall.bonding = everyBonding("4");
    wall.requirements = {
        {.outcome = RequirementOutcome::Breaks, .event = HitRequirement{.mass = 2.5, .speed = 1.0 / 3.0}},
        {.outcome = RequirementOutcome::Survives, .event = DropRequirement{.height = 1.75}},
        {.outcome = RequirementOutcome::Survives, .event = ImpulseRequirement{.impulse = 0.375}},
        {.outcome = RequirementOutcome::HoleAtMost, .event = DropRequirement{.height = 2.5}, .hole = 0.625}};
    SurfaceTriangle triangle;
    triangle.corners = {Vec3{0.0, 0.0, 0.125}, Vec3{1.0, 0.0, 0.125}, Vec3{0.0, 1.0, 0.125}};
    triangle.uvs = {Vec2{0.0, 1.0}, Vec2{1.0, 0.1}, Vec2{-0.5, 0.0}};
    triangle.material = 1;
    wall.surface = std::make_shared<Surface>(Surface{.materials = {"plaster", "edge"},
                                                     .front = {true, {{1.0, 0.0, 0.5, 0.0, 1.0, 0.25}}, 1},
                                                     .triangles = {triangle, triangle}});
    return wall;
}

inline std::vector<Shot> everyShot() {
    return {
        {.id = 30, .name = "box", .time = 0.5, .action = Throw{.size = {1.0, 2.0, 3.0}, .mass = 5.0, .speed = 12.0}},
        {.id = 31, .name = "pane", .action = Throw{.kind = ProjectileKind::Asset, .asset = 11}},
        {.id = 32, .name = "hammer", .action = Hammer{{1.0, 2.0, 3.0}, {0.0, -5.0, 0.0}, 0.25}},
        {.id = 33, .name = "bomb", .action = Blast{{4.0, 5.0, 6.0}, 250.0, 3.5}}};
}

inline std::vector<PlayTest> everyPlayTest() {
    return {{.id = 34, .name = "stands"},
            {.id = 35,
             .name = "falls",
             .state = "after the storm.rubblestate",
             .shots = {30, 33},
             .duration = 2.5,
             .expectations = {{.kind = ExpectationKind::StandsUntouched, .value = 1.0},
                              {.kind = ExpectationKind::BreaksIntoAtLeast, .instance = 21, .value = 4.0},
                              {.kind = ExpectationKind::NothingFaster, .value = 30.0}}}};
}

/// A project with every kind of element, in which no member has its default value.
inline Project fullProject() {
    Project project;
    project.nextId = 40;
    project.materials = {{.id = 1, .name = "brick"},
                         {.id = 2,
                          .name = "gl\xc3\xa4ss \"2\"\n",
                          .density = 2500.1,
                          .friction = 0.1,
                          .restitution = 0.3,
                          .tensileStrength = 4.5e7,
                          .fractureToughness = 1.0 / 3.0,
                          .youngsModulus = 7.1e10,
                          .outside = {0.1, 0.2, 0.3},
                          .inside = {1.0, 0.0, 1.0 / 3.0}}};

    project.assets = {fullWall(), boxAsset(9, 10, UniformScatter{}), boxAsset(11, 12, PlacedSeeds{})};
    project.assets[2].name = "pane";

    project.instances = {{.id = 20, .name = "left", .asset = 3},
                         {.id = 21,
                          .name = "right",
                          .asset = 9,
                          .pose = {{1.5, -2.0, 1.0 / 3.0}, Quat{0.6, -0.0, 0.8, 0.0}},
                          .threshold = 12.5,
                          .isFixed = true,
                          .isUnbreakable = true,
                          .isAnchored = true,
                          .bondStrength = 1.0 / 3.0,
                          .variant = 3,
                          .isHidden = true,
                          .isLocked = true}};
    project.ground = {.isOn = false, .height = -0.5, .friction = 0.7, .restitution = 0.2};
    project.gravity = {0.1, -1.62, std::numeric_limits<double>::denorm_min()};
    project.damage = {.rule = DamageRule::Momentum, .isThesis = true, .thesisThreshold = 1500.0};
    project.debris = {.lifetime = 12.5, .fade = 0.75, .maxFragments = 300};
    project.events = {.leastEnergy = 1.0 / 3.0, .maxRecords = 24};
    project.shots = everyShot();
    project.playTests = everyPlayTest();
    project.mortars = {{.id = 23, .name = "all"},
                       {.id = 24,
                        .name = "joints",
                        .instances = {20, 21},
                        .tolerance = 1.0 / 512.0,
                        .leastArea = 1.0 / 3.0,
                        .impulsePerArea = 62.5}};
    return project;
}

}  // namespace rubble
