#pragma once

#include "core/asset/import/AssetImport.h"
#include "viewport/scene/RenderScene.h"

#include <span>

namespace rubble {

/// The drawable meshes of an imported file, placed in the world.
struct SourceModel {
    Vec3 origin{0.0, 0.0, 0.0};                     // m, in the world: the centre of their bounding box
    std::shared_ptr<const SceneGeometry> geometry;  // relative to it; one solid per object
};

/// Takes O(n log n) in the file's triangles.
SourceModel sourceModel(const SourceScene& scene, double metresPerUnit, UpAxis up);

/// What is drawn over the meshes of a file.
struct ImportOverlay {
    const PrismFit* prism = nullptr;  // fitted or fallback
    const SolidFit* solid = nullptr;
    std::span<const MeshProblem> problems;
};

/// The preview of an import: the meshes and over them a prism, drawn like hulls, with an arrow along its axis; or the
/// box around a closed mesh; and in red the triangles and edges at which meshes cannot be cut. Bodies: the objects, the
/// prism and its arrow, then the red triangles. Picks are empty.
RenderScene importScene(const SourceModel& model, const ImportOverlay& overlay);

/// The box to frame for a problem, m, in the world: all that is marked if that is a small part of the meshes, else the
/// surroundings of its place.
Box3 surroundingsOf(const MeshProblem& problem, const SourceModel& model);

}  // namespace rubble
