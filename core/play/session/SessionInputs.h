#pragma once

#include "core/play/state/SessionState.h"

#include <optional>
#include <string>

namespace rubble {

/// Why an input is invalid, as a sentence; nothing if it is valid.
std::optional<std::string> faultOf(const PlayInput& input, const PlayScene& scene, const SessionState& state);
/// Applies the inputs that are due. Consecutive BreakInputs break their bodies together.
void applyInputs(SessionParts& parts);

}  // namespace rubble
