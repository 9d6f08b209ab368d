#pragma once

#include "core/base/ThreadPool.h"
#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"

#include <vector>

namespace rubble {

/// Memory of the functions below, reused from step to step.
struct ContactEnergyScratch {
    std::vector<StartMotion> starts;  // by body; of the awake ones
    std::vector<BodyLoss> losses;     // by body; of the awake ones
};

/// Keeps the velocities of the awake bodies; call before solveSubSteps().
void saveStartMotions(const WorldState& state, ThreadPool& threads, const Regions& regions,
                      ContactEnergyScratch& scratch);

/// Finds the mechanical energy that each awake body lost by its contacts in the sub-steps just solved, J: of all that
/// moved in another way than in free flight, kinetic and potential energy before less that after. Damping counts as
/// contact. Poses must be those before the step.
void findLosses(const WorldState& state, ThreadPool& threads, const Regions& regions, const SolverKernels& kernels,
                const SolverStep& step, ContactEnergyScratch& scratch);
/// Their sum, J.
double contactLoss(const WorldState& state, const ContactEnergyScratch& scratch);

/// The mechanical energy that the bodies of a contact lost by its impulses in the sub-steps just solved, J.
///
/// Impulses P at points whose relative velocities were u before the step and are u' after it change the kinetic energy
/// of all bodies by the sum of P . (u + u') / 2 over all contacts, exactly; and gravity by m g . (v + v') dt / 2, where
/// the potential energy changes by -m g . dx: see addGravity().
double contactEnergy(const WorldState& state, const ContactBlock& block, std::size_t lane,
                     const std::vector<StartMotion>& starts);

/// Adds to the energies of hits what gravity did in the step with their bodies, beyond what the mean velocity accounts
/// for: a body that hits the ground in the middle of a step has moved farther than that. Of several hits of a body the
/// one with the largest impulse gets it.
void addGravity(const WorldState& state, const SolverStep& step, const std::vector<StartMotion>& starts,
                std::vector<HitEvent>& hits);

/// Scales the energies of hits down to `loss`, J, what all contacts took together, where they took more: the rest they
/// passed on, to bodies that other contacts accelerated.
void limitHits(std::vector<HitEvent>& hits, double loss);

}  // namespace rubble
