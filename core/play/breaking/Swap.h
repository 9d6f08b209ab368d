#pragma once

#include "core/play/breaking/BreakImpulse.h"
#include "core/play/state/SessionState.h"

namespace rubble {

/// Finds the bodies that break in a step by its impacts, and swaps them for their fragments. True if any broke.
bool breakHitBodies(SessionParts& parts, std::span<const Impact> impacts);
/// Applies the break impulses and swaps the bodies for their fragments, in the given order.
void applyBreaks(SessionParts& parts, std::vector<PendingBreak> breaks);
/// The break of a body without an impactor.
PendingBreak pendingBreak(const SessionParts& parts, const PlayBody& body);

}  // namespace rubble
