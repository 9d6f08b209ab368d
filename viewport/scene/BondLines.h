#pragma once

#include "viewport/scene/AssetModel.h"

#include <span>

namespace rubble {

/// Adds a line for every bond between two visible solids, from centre to centre as drawn; its width grows with the
/// bond's area. `models`: one per batch. Linear in bonds.
void addBondLines(RenderScene& scene, std::span<const AssetModel* const> models);

}  // namespace rubble
