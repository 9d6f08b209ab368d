#pragma once

#include "core/physics/step/ContactEnergy.h"
#include "core/physics/step/ContinuousCollision.h"

#include <span>

namespace rubble {

/// Takes from bodies what energy contacts gave them, before poses are updated. `clamped`: those of clampFastBodies(),
/// which count as contacts. Returns the mechanical energy that all
/// contacts took, J, see contactLoss().
///
/// Contacts take energy or pass it on, and give none. Iterations that have not converged do: the spring of a light body
/// under a heavy one, whose damping is that of the light one, throws the heavy one back; and overlaps are resolved at a
/// speed that remains. So where the bodies of an island, which pushed each other in the step, have more energy after it
/// than before, their velocities are scaled down, relative to the motion of the island as a whole where it touches
/// nothing fixed: this keeps its momentum.
/// Source: Dinev, Liu, Li, Thomaszewski, Kavan 2018, "FEPR: Fast energy projection for real-time simulation of
/// deformable objects" (the idea; the projection is simpler here).
double limitEnergy(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverKernels& kernels,
                   const SolverStep& step, std::span<const BodyPair> clamped, ContactEnergyScratch& scratch);

}  // namespace rubble
