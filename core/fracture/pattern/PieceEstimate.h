#pragma once

#include "core/fracture/pattern/Pattern.h"

namespace rubble {

/// About how many pieces a pattern makes of a solid with an outline of `area` m²: at least 1; infinite for a spacing
/// of almost nothing. Computed from the parameters alone, so that too large a pattern is refused before it is carried
/// out. Slices cross each other and cells; crack lines count as if they did not, as they seldom do. Small pieces and
/// seeds without a cell are not taken off. 1 for a pattern that verifyPattern() rejects.
double estimatedPieces(const Pattern& pattern, double area);

/// About how many pieces a pattern makes of a closed mesh: at least 1; infinite for a spacing of almost nothing. Seeds
/// without a cell are not taken off. 1 for a pattern that verifyPattern() rejects.
double estimatedPieces(const Pattern& pattern, const SolidDomain& domain);

}  // namespace rubble
