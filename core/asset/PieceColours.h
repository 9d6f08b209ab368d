#pragma once

#include "core/asset/Project.h"

#include <cstdint>
#include <string_view>

namespace rubble {

/// A colour as 0xRRGGBB.
std::uint32_t packed(const Colour& colour);

/// The colour of a fragment by its id: the same wherever it is drawn, light enough for dark lines, and seldom like its
/// neighbour's.
Colour pieceColour(std::string_view fragmentId);

/// A colour for a value in [0, 1], from dark blue over green to yellow, evenly lighter; also told apart by those who do
/// not see red and green alike.
/// Source: a few stops of "viridis", van der Walt and Smith 2015.
Colour rampColour(double value);

/// What a cut through something of this colour shows: paler and darker.
Colour insideOf(const Colour& outside);

}  // namespace rubble
