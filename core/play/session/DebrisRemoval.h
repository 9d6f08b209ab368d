#pragma once

#include "core/play/state/SessionState.h"

namespace rubble {

/// In [0, 1]: how much of a body has faded out.
double fadeOf(const PlayBody& body, const Debris& debris, std::uint64_t step, double dt);
/// Removes debris that has faded out or exceeds Debris::maxPieces, and bodies that have left the world.
void removeDebris(const SessionParts& parts);

}  // namespace rubble
