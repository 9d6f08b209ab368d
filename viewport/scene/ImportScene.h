#pragma once

#include "core/asset/AssetImport.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// The meshes of a file where they stand in the world, to be drawn.
struct SourceModel {
    Vec3 origin{0.0, 0.0, 0.0};                     // m, in the world: the middle of all
    std::shared_ptr<const SceneGeometry> geometry;  // relative to it; a piece an object
};

/// O(n log n) in the file's triangles.
SourceModel sourceModel(const SourceScene& scene, double metresPerUnit, UpAxis up);

/// The picture of an import: the meshes; and the prism that was found or stands in, where one is given, drawn over them as
/// hulls are, with an arrow along its axis. Bodies: the objects, then the prism and its arrow. Picks name nothing.
RenderScene importScene(const SourceModel& model, const FoundPrism* prism);

}  // namespace rubble
