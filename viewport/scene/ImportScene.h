#pragma once

#include "core/asset/import/AssetImport.h"
#include "viewport/scene/RenderScene.h"

namespace rubble {

/// The drawable meshes of an imported file, placed in the world.
struct SourceModel {
    Vec3 origin{0.0, 0.0, 0.0};                     // m, in the world: the centre of their bounding box
    std::shared_ptr<const SceneGeometry> geometry;  // relative to it; one solid per object
};

/// Takes O(n log n) in the file's triangles.
SourceModel sourceModel(const SourceScene& scene, double metresPerUnit, UpAxis up);

/// The preview of an import: the meshes and, unless `prism` is null, over them the fitted or fallback prism, drawn like
/// hulls, with an arrow along its axis. Bodies: the objects, then the prism and its arrow. Picks are empty.
RenderScene importScene(const SourceModel& model, const PrismFit* prism);

}  // namespace rubble
