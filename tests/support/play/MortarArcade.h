#pragma once

#include "tests/support/play/MortarPortal.h"

#include <string>

namespace rubble::test {

/// The portals of mortarPortal() side by side, so that mortar joins their beams too, each with a wall on all of its
/// beam. Beams and walls have a span, m.
inline Project mortarArcade(int portals, double span = 0.8) {
    constexpr double kWidth = 4.0;  // m
    Project project = mortarPortal();
    project.assets[1].bonding.span = span;
    Asset wall = project.assets[1];
    wall.name = "wall";
    const Id id = addAsset(project, wall, {UniformScatter{.count = 20}});
    addInstance(project, id, "wall", {.position = {0.0, 4.5, 0.0}});
    const std::vector<Instance> first = project.instances;
    for (int k = 1; k < portals; ++k) {
        for (Instance instance : first) {
            instance.id = project.nextId++;
            instance.name += " " + std::to_string(k);
            instance.pose.position.x += kWidth * k;
            project.instances.push_back(std::move(instance));
        }
    }
    return project;
}

}  // namespace rubble::test
