#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"

namespace rubble {

/// Displaces bodies that the step being solved would leave deep in what is not dynamic: its contacts are those of its
/// beginning, and a body that rotates brings other corners down. Those that are deep already come out slowly, as far as
/// contacts do not push them. A body that is wedged, so that no displacement helps, moves less. Velocities stay, and
/// the contacts of the next step stop them. `isNear` is memory reused from step to step.
void displaceOutOfStatic(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverStep& step,
                         std::vector<std::uint8_t>& isNear);

}  // namespace rubble
