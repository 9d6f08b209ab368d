#pragma once

#include "core/asset/Project.h"

namespace rubble {

/// Width, height and depth of an asset's prism, m.
Vec3 sizeOf(const Asset& asset);

/// The asset stretched to a size, each above zero, about the middle of its outline's bounding box. Seeds that were placed
/// or moved by hand, and the look of the mesh it was imported from, go along; scatters are thrown anew.
Asset resized(Asset asset, Vec3 size);

}  // namespace rubble
