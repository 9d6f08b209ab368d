#pragma once

#include "core/asset/project/AssetShape.h"

namespace rubble {

/// The asset scaled to a size (each > 0) about the centre of its box. Seeds that were placed or
/// moved by hand and the surface of an imported mesh are scaled along; scattered seeds are generated anew.
Asset resized(Asset asset, Vec3 size);

}  // namespace rubble
