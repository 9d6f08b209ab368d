#pragma once

#include "core/physics/state/WorldState.h"

namespace rubble {

/// Corrects the displacement of a body in the step being solved, m, for what is not dynamic. Height that the body gains
/// by it is taken from its motion, as far as that suffices, since nothing else would pay for it.
void correctDisplacement(WorldState& state, std::uint32_t body, Vec3f displacement);

}  // namespace rubble
