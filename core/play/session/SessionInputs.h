#pragma once

#include "core/play/state/SessionState.h"

#include <optional>
#include <string>

namespace rubble {

/// What is wrong with an input, as a sentence, or nothing.
std::optional<std::string> faultOf(const PlayInput& input, const PlayScene& scene, const SessionState& state);
/// Applies the inputs that are due. Consecutive BreakInputs break their bodies together.
void applyInputs(const SessionParts& parts);

}  // namespace rubble
