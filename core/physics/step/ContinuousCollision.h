#pragma once

#include "core/physics/state/Regions.h"
#include "core/physics/step/BodyContacts.h"

namespace rubble {

/// The indices of two bodies.
using BodyPair = std::array<std::uint32_t, 2>;

/// Memory reused from step to step.
struct ContinuousScratch {
    std::vector<std::vector<std::uint32_t>> fast;  // bodies by region
    BodyContacts contacts;
};

/// Clamps the displacement of bodies that moved far relative to their width, where the middle of one of their hulls
/// would enter another body. The rest of their displacement is lost, and the contact of the next step finds them on the
/// side that they came from. What flies passes what else flies. Returns the bodies and what stopped them.
std::vector<BodyPair> clampFastBodies(WorldState& state, ThreadPool& threads, const Regions& regions,
                                      ContinuousScratch& scratch);

}  // namespace rubble
