#pragma once

#include "viewport/scene/AssetModel.h"

#include <span>

namespace rubble {

/// Gives every body of a scene its colours: by the material that its asset has in the project, by its piece, or by a figure,
/// from the least in the scene to the greatest. What is of no asset keeps its piece's. `models`: one a batch. Linear in bodies.
void paintBodies(RenderScene& scene, std::span<const AssetModel* const> models, const Project& project,
                 SceneColouring colouring);

}  // namespace rubble
