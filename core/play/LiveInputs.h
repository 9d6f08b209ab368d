#pragma once

#include "core/play/PlayInput.h"

#include <optional>
#include <vector>

namespace rubble {

/// What takes a project that is being played to another state of it while it goes on: other thresholds, physical materials and
/// gravity. Empty where the two play alike: names, shots, play-tests and intents say nothing. Nothing (no vector) where it must be
/// begun anew: another shape, pattern, placement, look or rule.
std::optional<std::vector<PlayInput>> liveInputs(const Project& played, const Project& now);

}  // namespace rubble
