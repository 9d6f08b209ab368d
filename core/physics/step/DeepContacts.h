#pragma once

#include "core/base/ThreadPool.h"
#include "core/physics/state/Regions.h"

namespace rubble {

/// Displaces bodies that overlap deeply and hardly move, such as splinters that are jammed between others: friction
/// holds them against the springs of contacts. Call between prepareContacts(), whose separations are read, and
/// finishBodies().
void displaceDeepContacts(WorldState& state, ThreadPool& threads, const Regions& regions, float dt);

}  // namespace rubble
