#pragma once

namespace rubble {

/// The smallest number that is 1, 2 or 5 times a power of ten and at least `minimum` (> 0): for ticks and scales.
double roundStep(double minimum);

}  // namespace rubble
