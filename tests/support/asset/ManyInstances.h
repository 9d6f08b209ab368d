#pragma once

#include "core/asset/library/StarterProject.h"
#include "tests/support/asset/ProjectParts.h"

#include <string>

namespace rubble::test {

/// The starter project with `count` more instances of its wall, in rows: to serialize it takes noticeable time.
inline Project manyInstances(int count) {
    constexpr int kInARow = 100;
    Project project = starterProject();
    const Id wall = project.assets[0].id;
    for (int k = 0; k < count; ++k) {
        const Vec3 at{2.0 * (k % kInARow + 1), project.instances[0].pose.position.y, 2.0 * (k / kInARow)};
        addInstance(project, wall, "wall " + std::to_string(k + 2), {.position = at});
    }
    return project;
}

}  // namespace rubble::test
