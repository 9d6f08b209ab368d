#pragma once

#include "tests/soak/Moment.h"
#include "tests/soak/SoakCase.h"

namespace rubble::soak {

/// Whether the first throw of a case breaks other bonds at 60 steps a second than at 240, in its scene without gravity,
/// where nothing moves before it hits. 95 % of all that break at one of them must break at both, until two steps of
/// 1/60 s after the first.
std::optional<Fault> frameRateFault(const SoakCase& one);

}  // namespace rubble::soak
