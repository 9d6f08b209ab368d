#pragma once

#include "core/play/state/SessionState.h"

#include <string>

namespace rubble {

/// Reports an input, or an impulse, without full effect; `body`: the one it was for, if any.
void addUnapplied(SessionParts& parts, const PlayBody* body, std::string message);
/// Reports an input that the world refused.
void reportRefused(SessionParts& parts, const PlayBody* body, const std::string& input, const Status& status);

/// Whether the world takes an impulse, N·s, at a point. If not, it is lost, which is reported with what caused it,
/// "The blow \"ball\""; `body`: the one it was for.
bool isApplicable(SessionParts& parts, const PlayBody& body, Vec3 impulse, Vec3 point, const std::string& cause);
/// Applies an impulse to a body of the session. All impulses of inputs, hits and breaks are applied by this function,
/// so that none is lost without a report. Returns whether it is applicable, see isApplicable().
bool applyImpulse(SessionParts& parts, BodyId body, Vec3 impulse, Vec3 point, const std::string& cause);

}  // namespace rubble
