#pragma once

#include "core/physics/Regions.h"
#include "core/physics/SolverKernels.h"

namespace rubble {

/// The impacts of the step about to be solved, in order of bodies: of each manifold, where its points that approach faster than
/// 0.5 m/s come together, the first within the step, the others no more than 5 mm after it; as fast as they will be when they meet,
/// the work of gravity until then counted. Of two bodies' manifolds those more than 5 mm behind the first wait: when they meet,
/// the first blow was dealt. Contacts must be prepared.
std::vector<Impact> impactsOf(const WorldState& state, const SolverStep& step);

/// Contacts that were hit in the step just solved, in order of bodies; `byRegion` is memory that is used again.
void listHits(const WorldState& state, WorkerTeam& team, const Regions& regions,
              std::vector<std::vector<HitEvent>>& byRegion, std::vector<HitEvent>& hits);

std::vector<ContactPoint> contactPointsOf(const WorldState& state);

}  // namespace rubble
