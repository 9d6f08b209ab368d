#pragma once

#include "core/physics/state/WorldState.h"

#include <cstddef>

namespace rubble {

/// The memory of a state, in bytes: of everything that grows with bodies and contacts. Shapes are shared and not
/// counted.
std::size_t byteCount(const WorldState& state);

}  // namespace rubble
