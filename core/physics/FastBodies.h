#pragma once

#include "core/physics/Regions.h"

namespace rubble {

/// Holds bodies back that moved far against their size where their centre would enter another body, however they spin: what is
/// left of their way is lost, and the contact of the next step finds them on the side that they came from. `byRegion` is memory
/// that is used again.
void holdBackFastBodies(WorldState& state, WorkerTeam& team, const Regions& regions,
                        std::vector<std::vector<std::uint32_t>>& byRegion);

}  // namespace rubble
