#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/WorldState.h"

#include <span>
#include <vector>

namespace rubble {

/// Whether warm starting, which gave a body its present velocities, may have thrown it: it changed them by more than
/// 0.5 m/s since they were `start`, beyond what gravity does in a sub-step. At rest it adds no more than that.
bool isThrown(const WorldState& state, std::uint32_t body, const StartMotion& start, const SolverStep& step);

/// Takes back the warm starting of the bodies that it threw, in their order, and of those that are thrown for the lack
/// of what was taken back, which it appends. Their contacts start from zero.
///
/// The impulses of the last step balance each other on a body. Where one of its contacts is gone since, or got other
/// points, the rest would throw it: a splinter of a few grams that lay under two hundred kilograms, by hundreds of
/// metres a second. Bodies whose impulses mostly balance are left alone: what is left of large ones may be fast, too.
void dropUnbalancedImpulses(WorldState& state, std::vector<std::uint32_t>& thrown, std::span<const StartMotion> starts,
                            const SolverStep& step);

}  // namespace rubble
