#pragma once

#include "tests/support/play/Sessions.h"

namespace rubble::test {

/// Two bonded piers of 1 x 3 x 1 m on the ground, anchored where they touch it, and a bonded beam of 4 x 1 x 1 m upon
/// them, all joined by mortar. Instances: left, right, beam; bodies 1, 2, 3.
inline Project mortarPortal(double impulsePerArea = 500.0) {
    Project project;
    const Id stone = addMaterial(project, {.name = "stone", .density = 2000.0});
    const auto block = [&](const char* name, Vec2 half) {
        const Id asset =
            addAsset(project, {.name = name, .material = stone, .shape = Prism{{rectangle(-half, half), {}}, 1.0}},
                     {UniformScatter{.count = 20}});
        project.assets.back().breakAs = BreakAs::Bonded;
        project.assets.back().bonding.impulsePerArea = 200.0;
        return asset;
    };
    const Id pier = block("pier", {0.5, 1.5}), beam = block("beam", {2.0, 0.5});
    addInstance(project, pier, "left", {.position = {-1.5, 1.5, 0.0}});
    addInstance(project, pier, "right", {.position = {1.5, 1.5, 0.0}});
    addInstance(project, beam, "beam", {.position = {0.0, 3.5, 0.0}});
    for (int k = 0; k < 2; ++k) project.instances[k].isAnchored = true;
    project.mortars = {{.id = project.nextId++, .name = "joints", .impulsePerArea = impulsePerArea}};
    return project;
}

}  // namespace rubble::test
