#pragma once

#include "core/asset/project/Project.h"
#include "tests/support/geometry/SolidShapes.h"

#include <string>

namespace rubble::test {

/// An asset of a mesh that can be cut as it is, with a layer of scattered seeds; material 1.
inline Asset meshAsset(TriangleMesh mesh, std::uint32_t seeds, Id id = 3) {
    Asset asset{.id = id, .name = "sculpture", .material = 1, .shape = closedMesh(std::move(mesh)).value()};
    asset.pattern.layers.push_back({.id = id + 1, .randomSeed = 7, .parameters = UniformScatter{.count = seeds}});
    return asset;
}

}  // namespace rubble::test
