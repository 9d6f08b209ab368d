#pragma once

#include "viewport/scene/AssetModel.h"

#include <span>

namespace rubble {

/// Adds a line for every two pieces that touch and are not hidden, from middle to middle where they are drawn; its width grows
/// with the area they share. `models`: one a batch. Linear in bonds.
void addBonds(RenderScene& scene, std::span<const AssetModel* const> models);

}  // namespace rubble
