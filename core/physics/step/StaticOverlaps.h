#pragma once

#include "core/physics/state/Regions.h"

namespace rubble {

/// Displaces bodies that the step being solved would leave deep in what is not dynamic: its contacts are those of its
/// beginning, and a body that rotates brings other corners down. Velocities stay, and the contact of the next step
/// stops them. How deep bodies may be is a fraction of their width, and never less than they were at the beginning of
/// the step.
void displaceOutOfStatic(WorldState& state, ThreadPool& threads, const Regions& regions);

}  // namespace rubble
