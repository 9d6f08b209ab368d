#pragma once

#include "core/asset/project/Project.h"

namespace rubble {

/// Width, height and depth of an asset's prism, m.
Vec3 sizeOf(const Asset& asset);

/// The asset scaled to a size (each > 0) about the centre of its outline's bounding box. Seeds that were placed or
/// moved by hand and the surface of an imported mesh are scaled along; scattered seeds are generated anew.
Asset resized(Asset asset, Vec3 size);

}  // namespace rubble
