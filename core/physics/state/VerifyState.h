#pragma once

#include "core/physics/state/WorldState.h"

#include <optional>
#include <string>

namespace rubble {

/// Where a state that was read from outside contradicts itself, as a place: "contacts[12].next"; nothing if it can be
/// simulated: every index leads to what leads back, every list has what it must and nothing else, and every number is
/// in its range. Numbers must be finite. O(n log n) for n bodies and contacts.
std::optional<std::string> verifyState(const WorldState& state);

}  // namespace rubble
