#pragma once

#include "core/physics/SolverKernels.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// The impacts of the step about to be solved, in order of bodies: of each manifold, where its points that approach faster than
/// 0.5 m/s come together, the first within the step, the others no more than 5 mm after it; as fast as they will be when they meet,
/// the work of gravity until then counted. Contacts must be prepared.
std::vector<Impact> impactsOf(const WorldState& state, const SolverStep& step);

/// Contacts that were hit in the step just solved, in order of bodies.
void listHits(const WorldState& state, std::vector<HitEvent>& hits);

std::vector<ContactPoint> contactPointsOf(const WorldState& state);

}  // namespace rubble
