#pragma once

#include "viewport/scene/AssetModel.h"

#include <span>

namespace rubble {

/// Colours every body of a scene by the material of its asset in the project, by solid, by cluster, or by a quantity on
/// a ramp from its least to its greatest value in the scene, which becomes its `colourRange`; grey where it has no
/// value, violet where bonds never break. Bodies without an asset are coloured by solid. `models`: one per batch.
/// Linear in bodies.
void colourBodies(RenderScene& scene, std::span<const AssetModel* const> models, const Project& project,
                  SceneColouring colouring);

}  // namespace rubble
