#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// Slows bodies that roll over hulls of many faces, see isRounded(). The faces stand for a round surface; a real one
/// yields a little where it touches, and comes to rest, where one of faces rocks to and fro for long. Call after
/// solveSubSteps(), whose impulses it reads.
void resistRolling(WorldState& state);

}  // namespace rubble
