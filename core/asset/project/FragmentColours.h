#pragma once

#include "core/asset/project/Project.h"

#include <cstdint>
#include <string_view>

namespace rubble {

/// A colour as 0xRRGGBB.
std::uint32_t packed(const Colour& colour);

/// The colour of a fragment, by its id: the same wherever it is drawn, light enough for dark lines, and seldom close to
/// its neighbours'.
Colour fragmentColour(std::string_view fragmentId);

/// The colour of a member of a series, by its number: its hue is far from those of the members before it. `lightness`:
/// perceived, in [0, 1].
Colour seriesColour(std::uint32_t number, double lightness);

/// A colour for a value in [0, 1], from dark blue over green to yellow, with uniformly increasing lightness; readable
/// with red-green colour blindness.
/// Source: six stops of "viridis", van der Walt and Smith 2015.
Colour rampColour(double value);

/// The default colour of inside faces for an outside colour: less saturated and darker.
Colour insideOf(const Colour& outside);

}  // namespace rubble
