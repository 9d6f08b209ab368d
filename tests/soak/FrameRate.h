#pragma once

#include "tests/soak/SoakCase.h"

#include <optional>

namespace rubble::soak {

/// Of the bonds that the first throw of a case breaks at 60 or at 240 steps a second, the part that it breaks at both
/// (Jaccard index), in its scene without gravity, where nothing moves before it hits: at the end of the step of 1/60 s
/// in which the first break. Without those that it breaks at a speed 10 % higher and not at one 10 % lower, which are
/// near their limit. Nothing if it breaks none.
std::optional<double> frameRateAgreement(const SoakCase& one);

}  // namespace rubble::soak
