#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"
#include "core/physics/step/BodyContacts.h"

namespace rubble {

/// Memory reused from step to step.
struct StaticOverlapScratch {
    std::vector<std::vector<std::uint32_t>> moving;  // bodies by region
    BodyContacts contacts;
    std::vector<std::size_t> begins;
};

/// Displaces bodies that the step being solved would leave deep in what is not dynamic: its contacts are those of its
/// beginning, and a body that rotates brings other corners down. Those that are deep already come out slowly, as far as
/// contacts do not push them. A body that is wedged, so that no displacement helps, moves less. Velocities stay, and
/// the contacts of the next step stop them.
void displaceOutOfStatic(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverStep& step,
                         StaticOverlapScratch& scratch);

}  // namespace rubble
