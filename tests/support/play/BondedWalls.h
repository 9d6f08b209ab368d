#pragma once

#include "core/structure/clusters/ClusterEditing.h"
#include "tests/support/play/Sessions.h"

namespace rubble::test {

/// The id of the only asset of the projects below, and the name of its instance.
inline constexpr const char* kWall = "wall";

/// A bonded wall of 4 x 3 x 0.25 m in `pieces` fragments on the ground, anchored where it touches it.
inline Project bondedWall(std::uint32_t pieces = 300, double impulsePerArea = 100.0) {
    Project project;
    const Id stone = addMaterial(project, {.name = "stone", .density = 2000.0});
    const Id wall = addAsset(
        project, {.name = kWall, .material = stone, .shape = Prism{{rectangle({-2.0, -1.5}, {2.0, 1.5}), {}}, 0.25}},
        {UniformScatter{.count = pieces}});
    project.assets[0].breakAs = BreakAs::Bonded;
    project.assets[0].bonding.impulsePerArea = impulsePerArea;
    addInstance(project, wall, kWall, {.position = {0.0, 1.5, 0.0}});
    project.instances[0].isAnchored = true;
    return project;
}

/// A bonded portal of stone: two piers of 0.5 x 2 m, 3 m apart, and a lintel of 4 x 0.5 m on them. `delay`: of a
/// collapse, s.
inline Project bondedPortal(double span, double delay) {
    Project project = bondedWall(1, 1e4);
    Asset& asset = project.assets[0];
    asset.prism().outline.outer = {{-2.0, -1.25}, {-1.5, -1.25}, {-1.5, 0.75}, {1.5, 0.75},
                                   {1.5, -1.25},  {2.0, -1.25},  {2.0, 1.25},  {-2.0, 1.25}};
    asset.pattern = patternOf(project, {UniformScatter{.count = 60}});
    asset.bonding.span = span;
    asset.bonding.collapseDelay = delay;
    project.instances[0].pose.position = {0.0, 1.25, 0.0};
    return project;
}

/// bondedWall() in clusters of two levels: of `coarse` clusters, each of about four fine ones.
inline Project clusteredWall(std::uint32_t pieces = 300, std::uint32_t coarse = 12, double impulsePerArea = 100.0) {
    Project project = bondedWall(pieces, impulsePerArea);
    Asset& asset = project.assets[0];
    const Bake baked = *bake(asset);
    for (const std::uint32_t level : {0u, 1u})
        asset.bonding.clusters =
            ClusterEditing(asset, baked, 0, level).propose({.value = level == 0 ? coarse : 4 * coarse});
    return project;
}

/// A ball thrown along -z at a point of the wall's front.
inline Throw ballAtWall(Vec2 at = {0.0, 1.8}, double mass = 150.0, double speed = 20.0) {
    return {.kind = ProjectileKind::Ball,
            .size = {0.3, 0.3, 0.3},
            .mass = mass,
            .from = {at, 2.0},
            .to = {at, 0.0},
            .speed = speed};
}

/// The body of the wall: the one that kept its number.
inline const PlayBody& wallOf(const Session& session) { return *session.body(1); }

}  // namespace rubble::test
