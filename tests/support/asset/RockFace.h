#pragma once

#include "core/structure/clusters/ClusterEditing.h"
#include "tests/support/asset/ProjectParts.h"

namespace rubble::test {

/// projects/rock-face.rubble: a bonded face of granite in 420 fragments, which are in 60 clusters of level 1 and these
/// in 12 of level 0. It comes off in large parts, which break up when they land.
inline Project rockFace() {
    Project project;
    const Id granite = addMaterial(project, {.name = "granite",
                                             .density = 2650.0,
                                             .friction = 0.6,
                                             .outside = {0.52, 0.50, 0.49},
                                             .inside = {0.66, 0.64, 0.62},
                                             .finish = Finish::Stone});
    const Ring outline{{-4.0, 0.0}, {2.4, 0.0},  {2.8, 2.0},  {5.2, 2.8}, {5.0, 4.4},
                       {1.2, 5.1},  {-0.8, 4.6}, {-2.6, 5.3}, {-4.2, 3.1}};
    Asset asset{.name = "rock face", .material = granite, .shape = Prism{{outline, {}}, 0.9}};
    asset.breakAs = BreakAs::Bonded;
    asset.bonding.impulsePerArea = 120.0;
    asset.bonding.radius = 0.6;
    asset.bonding.minimumIsland = 3;
    const Id id =
        addAsset(project, asset, {BlueNoise{.minimumDistance = 0.25, .count = 420}, LloydRelaxation{.rounds = 2}});
    Asset& added = project.assets[0];
    const Bake baked = *bake(added);
    for (const auto& [level, clusters] : {std::pair(0u, 12u), std::pair(1u, 60u)})
        added.bonding.clusters = ClusterEditing(added, baked, 0, level).propose({.value = clusters});
    addInstance(project, id, "rock face", {.position = {0.0, 0.0, 0.0}});
    project.instances[0].isAnchored = true;
    addShot(project, "boulder on the overhang", 0.5,
            Throw{.kind = ProjectileKind::Ball,
                  .size = Vec3(1.4),
                  .mass = 4000.0,
                  .from = {4.2, 14.0, 0.0},
                  .to = {4.2, 4.0, 0.0},
                  .speed = 16.0});
    addShot(project, "blast at the foot", 0.5, Blast{.at = {-2.0, 1.0, 0.9}, .impulse = 6000.0, .radius = 2.0});
    addPlayTest(project, {.name = "stands",
                          .duration = 3.0,
                          .expectations = {{.kind = ExpectationKind::StandsUntouched, .value = 3.0}}});
    return project;
}

}  // namespace rubble::test
