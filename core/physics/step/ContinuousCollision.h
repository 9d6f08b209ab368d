#pragma once

#include "core/physics/state/Regions.h"

namespace rubble {

/// The indices of two bodies.
using BodyPair = std::array<std::uint32_t, 2>;

/// Clamps the displacement of bodies that moved far relative to their width, where the middle of one of their hulls
/// would enter another body. The rest of their displacement is lost, and the contact of the next step finds them on the
/// side that they came from. Returns the bodies and what stopped them. `byRegion` is memory reused from step to step.
std::vector<BodyPair> clampFastBodies(WorldState& state, ThreadPool& threads, const Regions& regions,
                                      std::vector<std::vector<std::uint32_t>>& byRegion);

}  // namespace rubble
