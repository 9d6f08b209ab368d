#pragma once

#include "core/asset/import/AssetImport.h"
#include "core/asset/project/AssetShape.h"
#include "core/io/mesh/MeshImport.h"
#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <numbers>
#include <string>

namespace rubble::test {

/// Runs tools/sculptures, which writes column.obj, vase.obj and head.obj into a folder.
inline void makeSculptures(const QString& folder) {
    QProcess script;
    script.start("python3", {RUBBLE_SOURCE_DIR "/tools/sculptures", folder});
    if (!script.waitForFinished(-1) || script.exitCode() != 0) qFatal("%s", script.readAllStandardError().constData());
}

/// The mesh of a sculpture as an import gives it, y up, its box around the origin.
inline std::shared_ptr<const ClosedMesh> importedSculpture(const QString& file) {
    const Result<SourceScene> scene = importMesh(file.toStdString(), RUBBLE_IMPORTER, {});
    if (!scene) qFatal("%s", scene.error().message.c_str());
    const Result<ImportOutcome> outcome =
        importedInto({}, *scene, "sculpture", {.up = UpAxis::Z, .as = ImportShape::Solid}, {});
    if (!outcome) qFatal("%s", outcome.error().message.c_str());
    return std::get<std::shared_ptr<const ClosedMesh>>(outcome->project.assets.at(0).shape);
}

inline constexpr double kPedestalHeight = 0.9;  // m
inline constexpr double kStepHeight = 0.16;     // m
inline constexpr double kHeadBonds = 500.0;     // N·s/m²

/// A block of stone below a sculpture. Its outline is in the xy plane, its foot at y = 0.
inline Id addPedestal(Project& project, const std::string& name, Id material, double width, double height) {
    const Prism block{{rectangle({-width / 2.0, 0.0}, {width / 2.0, height}), {}}, width};
    return addAsset(project, {.name = name, .material = material, .shape = block, .threshold = 4000.0},
                    {UniformScatter{.count = 12}, LloydRelaxation{.rounds = 3}});
}

/// Places a sculpture on a pedestal at a place on the ground, and returns the instance of the sculpture.
inline Id addOnPedestal(Project& project, Id pedestal, Id sculpture, double x, double z) {
    const Asset& block = *findAsset(project, pedestal);
    const Asset& asset = *findAsset(project, sculpture);
    const double top = boundsOf(block).max.y;
    addInstance(project, pedestal, block.name + " of the " + asset.name, {.position = {x, 0.0, z}});
    project.instances.back().isFixed = true;
    addInstance(project, sculpture, asset.name, {.position = {x, top - boundsOf(asset).min.y, z}});
    return project.instances.back().id;
}

/// Small fragments become part of their neighbours.
inline constexpr Shaping kNoSmallFragments{.smallPieces = {.rule = SmallPieceRule::Merge, .limit = 0.1}};

/// Nine drums, which break into eight fragments each.
inline Id addColumn(Project& project, Id material, std::shared_ptr<const ClosedMesh> mesh) {
    const Id id = addAsset(project,
                           {.name = "column",
                            .material = material,
                            .shape = std::move(mesh),
                            .shaping = kNoSmallFragments,
                            .threshold = 150.0},
                           {Slices{.cuts = 8, .angle = 0.0, .offsetVariation = 0.2, .angleVariation = 0.08}});
    Level level{.pattern = patternOf(project, {BlueNoise{.minimumDistance = 0.1, .count = 8}}), .threshold = 120.0};
    project.assets.back().levels.push_back(std::move(level));
    return id;
}

/// Sherds, small around a point of the belly.
inline Id addVase(Project& project, Id material, std::shared_ptr<const ClosedMesh> mesh) {
    return addAsset(project,
                    {.name = "vase",
                     .material = material,
                     .shape = std::move(mesh),
                     .shaping = kNoSmallFragments,
                     .threshold = 6.0},
                    {BlueNoise{.minimumDistance = 0.06, .count = 70},
                     ImpactScatter{.count = 20, .radius = 0.06, .centreHeight = 0.16}});
}

/// Bonded, with most of its fragments near the surface: a blow takes off what it meets, and the rest stays in one
/// piece.
inline Id addHead(Project& project, Id material, std::shared_ptr<const ClosedMesh> mesh) {
    Asset asset{.name = "head", .material = material, .shape = std::move(mesh), .shaping = kNoSmallFragments};
    asset.breakAs = BreakAs::Bonded;
    asset.bonding.impulsePerArea = kHeadBonds;
    asset.bonding.radius = 0.1;
    asset.bonding.minimumIsland = 2;
    return addAsset(project, std::move(asset),
                    {SurfaceScatter{.count = 60, .maxDepth = 0.04}, UniformScatter{.count = 20}});
}

/// The instances of the sculptures.
struct SculptureInstances {
    Id column = 0, vase = 0, head = 0;
};

/// What is thrown, dropped and hit, with tests of it.
inline void addSculptureShots(Project& project, Id vase, const SculptureInstances& placed) {
    constexpr double kTime = 0.5;  // s: before it all must stand
    const Id ball = addShot(project, "ball at the column", kTime,
                            Throw{.kind = ProjectileKind::Ball,
                                  .size = Vec3(0.34),
                                  .mass = 80.0,
                                  .from = {-0.6, 1.6, 5.0},
                                  .to = {-1.2, 1.8, 0.0},
                                  .speed = 18.0});
    const Id thrown = addShot(project, "vase thrown at the column", kTime,
                              Throw{.kind = ProjectileKind::Asset,
                                    .asset = vase,
                                    .from = {0.6, 1.6, 3.5},
                                    .to = {-1.2, 2.1, 0.0},
                                    .speed = 9.0});
    const Id dropped = addShot(project, "vase dropped", kTime,
                               Throw{.kind = ProjectileKind::Asset,
                                     .asset = vase,
                                     .from = {0.25, 2.0, 1.2},
                                     .to = {0.25, 0.0, 1.2},
                                     .speed = 0.5});
    const Id hammer = addShot(project, "hammer on the face", kTime,
                              Hammer{.at = {0.7, kPedestalHeight + 0.37, 0.13}, .impulse = {0.0, 0.0, -30.0}});
    using enum ExpectationKind;
    addPlayTest(project, {.name = "all stand", .duration = 3.0, .expectations = {{StandsUntouched, 0, 3.0}}});
    addPlayTest(project, {.name = "a ball brings the column down",
                          .shots = {ball},
                          .expectations = {{BreaksIntoAtLeast, placed.column, 9.0}, {DoesNotBreak, placed.head, 0.0}}});
    addPlayTest(project, {.name = "a vase does not move the column",
                          .shots = {thrown},
                          .expectations = {{StandsUntouched, placed.column, 5.0}}});
    addPlayTest(project, {.name = "sherds leave the sculptures alone",
                          .shots = {dropped},
                          .expectations = {{StandsUntouched, placed.vase, 5.0}, {StandsUntouched, placed.head, 5.0}}});
    addPlayTest(project, {.name = "a hammer takes the face off, and the head stays up",
                          .shots = {hammer},
                          .expectations = {{Breaks, placed.head, 0.0}, {StaysUp, placed.head, 0.3}}});
}

/// projects/sculptures.rubble: a fluted column in drums, a vase and a head, as tools/sculptures makes them, on
/// pedestals.
inline Project sculptures() {
    const QTemporaryDir folder;
    makeSculptures(folder.path());
    Project project;
    const Id marble = addMaterial(project, {.name = "marble",
                                            .density = 2700.0,
                                            .friction = 0.6,
                                            .outside = {0.90, 0.88, 0.84},
                                            .inside = {0.96, 0.95, 0.93},
                                            .finish = Finish::Stone});
    const Id clay = addMaterial(project, {.name = "fired clay",
                                          .density = 1900.0,
                                          .friction = 0.5,
                                          .outside = {0.72, 0.38, 0.22},
                                          .inside = {0.82, 0.55, 0.38},
                                          .finish = Finish::Plaster});
    const Id granite = addMaterial(project, {.name = "granite",
                                             .density = 2650.0,
                                             .friction = 0.6,
                                             .outside = {0.45, 0.46, 0.48},
                                             .inside = {0.60, 0.61, 0.62},
                                             .finish = Finish::Stone});
    const Id column = addColumn(project, marble, importedSculpture(folder.filePath("column.obj")));
    const Id vase = addVase(project, clay, importedSculpture(folder.filePath("vase.obj")));
    const Id head = addHead(project, marble, importedSculpture(folder.filePath("head.obj")));
    const Id step = addPedestal(project, "step", granite, 0.9, kStepHeight);
    const Id pedestal = addPedestal(project, "pedestal", granite, 0.44, kPedestalHeight);
    const SculptureInstances placed{.column = addOnPedestal(project, step, column, -1.2, 0.0),
                                    .vase = addOnPedestal(project, pedestal, vase, -0.2, 0.0),
                                    .head = addOnPedestal(project, pedestal, head, 0.7, 0.0)};
    project.instances.back().isAnchored = true;
    addSculptureShots(project, vase, placed);
    return project;
}

}  // namespace rubble::test
