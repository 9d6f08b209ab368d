#pragma once

#include "core/play/state/SessionState.h"

#include <string>

namespace rubble {

/// Reports an input without full effect; `body`: the one it was for, if any.
void addUnapplied(const SessionParts& parts, const PlayBody* body, std::string message);
/// Reports an input that the world refused.
void reportRefused(const SessionParts& parts, const PlayBody* body, const std::string& input, const Status& status);

}  // namespace rubble
