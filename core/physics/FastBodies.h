#pragma once

#include "core/physics/WorldState.h"

namespace rubble {

/// Holds bodies back that moved far against their size where their centre would enter another body, however they spin: what is
/// left of their way is lost, and the contact of the next step finds them on the side that they came from.
void holdBackFastBodies(WorldState& state);

}  // namespace rubble
