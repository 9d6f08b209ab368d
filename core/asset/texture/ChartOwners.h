#pragma once

#include "core/asset/texture/TextureAtlas.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// For each texel of a chart, gutter included, the index of the face that its centre is in; of those beside all faces,
/// that of the nearest texel in one. Row by row, from the lowest. Of faces that a centre is in equally, the first.
/// `density`: texels/m.
std::vector<std::uint32_t> chartOwners(const PlacedChart& placed, double density);

}  // namespace rubble
