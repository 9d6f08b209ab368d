#pragma once

#include "tests/support/asset/Bonds.h"
#include "tests/support/asset/Projects.h"

namespace rubble {

/// boxProject() with a level that breaks as bonded, a second instance, "pier", beside the first, and two mortars.
inline Project bondedProject() {
    Project project = boxProject(UniformScatter{.count = 8});
    Asset& box = project.assets[0];
    box.levels = {{.pattern = {{{.id = 4, .parameters = BlueNoise{}}}}, .bondStrength = 0.5}};
    box.breakAs = BreakAs::Bonded;
    box.bonding = everyBonding("3");
    project.instances[0].isAnchored = true;
    project.instances.push_back(
        {.id = 11, .name = "pier", .asset = 2, .pose = {.position = {1.0, 0.0, 0.0}}, .bondStrength = 2.0});
    project.mortars = {{.id = 30,
                        .name = "joints",
                        .instances = {10, 11},
                        .tolerance = 0.01,
                        .leastArea = 1e-3,
                        .impulsePerArea = 250.0},
                       {.id = 31, .name = "glue"}};
    return project;
}

}  // namespace rubble
