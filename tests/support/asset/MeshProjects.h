#pragma once

#include "tests/support/asset/MeshAsset.h"
#include "tests/support/asset/Projects.h"

namespace rubble::test {

/// A project with a box, asset 2, and a mesh, asset 50.
inline Project meshProject(TriangleMesh mesh = bumpySphere(6)) {
    Project project = boxProject(UniformScatter{.count = 5});
    project.assets.push_back(meshAsset(std::move(mesh), 8, 50));
    return project;
}

}  // namespace rubble::test
