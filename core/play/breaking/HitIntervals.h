#pragma once

#include "core/play/state/SessionState.h"

#include <span>

namespace rubble {

/// The length of the intervals that steps are divided into where something is hit that may break, s: what breaks must
/// not depend on the length of steps.
inline constexpr double kHitInterval = 1.0 / 240.0;

/// How long steps are divided after a break, s: what came free hits what stands beside it.
inline constexpr double kDividedTime = 0.05;

/// The number of equal intervals of a step of dt seconds, none longer than kHitInterval.
int hitIntervals(double dt);

/// Whether one of the impacts of a step may break a body or damage a bond: those of the intervals may differ from those
/// of the step by a quarter.
bool mayBreak(const SessionParts& parts, std::span<const Impact> impacts);

}  // namespace rubble
