#pragma once

#include "core/physics/state/Regions.h"

namespace rubble {

/// Clamps the displacement of bodies that moved far relative to their width, where their centre would enter another
/// body. The rest of their displacement is lost, and the contact of the next step finds them on the side that they came
/// from. `byRegion` is memory reused from step to step.
void clampFastBodies(WorldState& state, ThreadPool& threads, const Regions& regions,
                     std::vector<std::vector<std::uint32_t>>& byRegion);

}  // namespace rubble
