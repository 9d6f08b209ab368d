#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"
#include "core/physics/step/ContactEnergy.h"

#include <span>

namespace rubble {

/// The impacts of the coming step, sorted by bodies: one per manifold, at the centroid of the points that approach
/// faster than 0.5 m/s, the first within the step and the others at most 5 mm after it. Bodies that are more than 5 mm
/// apart are swept to where they touch. The approach speed is that at the time of impact, with the work of gravity
/// until then. Of several manifolds of two bodies, those more than 5 mm behind the first are ignored, since the first
/// impact changes the velocities before they touch. Contacts must be prepared.
///
/// `isWanted`: of each body, whether its impacts are; empty: those of all.
std::vector<Impact> findImpacts(const WorldState& state, const SolverStep& step,
                                std::span<const std::uint8_t> isWanted = {});

/// Appends the hit events of the step just solved, sorted by bodies; `byRegion` is memory reused from step to step,
/// `starts` the velocities before it, by body.
void findHits(const WorldState& state, ThreadPool& threads, const Regions& regions,
              const std::vector<StartMotion>& starts, std::vector<std::vector<HitEvent>>& byRegion,
              std::vector<HitEvent>& hits);

/// World::contactPoints().
std::vector<ContactPoint> contactPointsOf(const WorldState& state);

}  // namespace rubble
