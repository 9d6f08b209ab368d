#pragma once

#include "core/physics/SolverKernels.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// The impacts of the step about to be solved, in order of bodies: of each manifold, where its approaching points that will touch
/// within the step come together, faster than 0.5 m/s. Contacts must be prepared.
std::vector<Impact> impactsOf(const WorldState& state, const SolverStep& step);

/// Contacts that were hit in the step just solved, in order of bodies.
void listHits(const WorldState& state, std::vector<HitEvent>& hits);

std::vector<ContactPoint> contactPointsOf(const WorldState& state);

}  // namespace rubble
