#pragma once

#include "core/play/scene/PlayInput.h"

#include <optional>
#include <vector>

namespace rubble {

/// The inputs that change a project into another state of it during play: thresholds, physical materials and gravity.
/// Empty if both behave the same in play: names, shots, play-tests and requirements have no effect. Nothing (no vector)
/// if play must be restarted: for another shape, pattern, placement, surface or rule.
std::optional<std::vector<PlayInput>> liveInputs(const Project& played, const Project& now);

}  // namespace rubble
