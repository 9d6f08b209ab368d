#pragma once

#include "tests/support/asset/ProjectParts.h"
#include "tests/support/geometry/Outlines.h"

namespace rubble::test {

/// A wall of 4 x 2.6 m around the origin; the door is a notch from below, the window a hole.
inline Polygon outlineWithDoorAndWindow() {
    const Ring outer = {{-2.0, -1.3}, {0.5, -1.3}, {0.5, 0.75}, {1.4, 0.75},
                        {1.4, -1.3},  {2.0, -1.3}, {2.0, 1.3},  {-2.0, 1.3}};
    return {outer, {reversed(rectangle({-1.4, -0.4}, {-0.2, 0.75}))}};
}

/// projects/wall-with-openings.rubble: one outline with a door and a window; its larger pieces are fractured again.
inline Project wallWithOpenings() {
    Project project;
    const Id concrete = addMaterial(project, {.name = "concrete",
                                              .density = 2400.0,
                                              .friction = 0.7,
                                              .outside = {0.72, 0.71, 0.68},
                                              .inside = {0.56, 0.54, 0.5}});
    const Asset asset{.name = "wall with openings",
                      .material = concrete,
                      .shape = Prism{outlineWithDoorAndWindow(), 0.24},
                      .threshold = 1500.0};
    const Id id =
        addAsset(project, asset, {BlueNoise{.minimumDistance = 0.25, .count = 60}, LloydRelaxation{.rounds = 2}});
    project.assets[0].levels = {{.pattern = patternOf(project, {UniformScatter{.count = 3}}), .minimumVolume = 0.03}};
    addInstance(project, id, "wall", {.position = {0.0, 1.3, 0.0}});
    return project;
}

}  // namespace rubble::test
