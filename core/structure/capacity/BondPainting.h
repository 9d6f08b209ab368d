#pragma once

#include "core/asset/project/Bonding.h"
#include "core/fracture/fragments/Fragment.h"

#include <span>
#include <vector>

namespace rubble {

/// Whether a stroke touches a polygon in canonical winding: its line comes within its radius of it.
bool touches(const BondStroke& stroke, const Polygon& polygon);

/// Whether each fragment is painted with a brush: of the strokes of the brush that touch its outline, the last does not
/// erase. Strokes are in the frame of Fragment::offset().
std::vector<bool> paintedFragments(const Fragments& fragments, std::span<const BondStroke> strokes, BondBrush brush);

}  // namespace rubble
