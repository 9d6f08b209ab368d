#pragma once

#include "core/physics/state/WorldState.h"
#include "core/physics/step/LoadPaths.h"

#include <span>

namespace rubble {

/// Displaces bodies that overlap deeply and hardly move, such as splinters that are jammed between others: friction
/// holds them against the springs of contacts. Call between prepareContacts(), whose separations are read, and
/// finishBodies(). `blocks`: those that are deep, by region.
void displaceDeepContacts(WorldState& state, std::span<const BlockList> blocks, float dt);

}  // namespace rubble
