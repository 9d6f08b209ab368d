#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"
#include "core/physics/state/WorldState.h"

namespace rubble {

/// The softness of one of `count` >= 1 manifolds of the same two bodies that push in the same direction, so that all
/// together are as soft as a single one, `ofOne`: each leaves (1 - massScale) of the speed to the next, and the product
/// over all must be that of one. Solved with the softness of one, each would refill what another releases, and
/// the pair of bodies would be rigid; four sub-steps cannot bring that to rest.
Softness sharedSoftness(const Softness& ofOne, double count);

/// Sets the softness of the manifolds of bodies of several hulls, after prepareContacts(). `count` of sharedSoftness()
/// is the sum of the cosines between a manifold's normal and those of the pair's active manifolds.
void softenSharedContacts(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverStep& step);

}  // namespace rubble
