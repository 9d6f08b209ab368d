#pragma once

#include "core/physics/SolverKernels.h"
#include "core/physics/WorkerTeam.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// Memory that is used again from step to step.
struct SolveScratch {
    std::vector<std::uint32_t> spinners;  // bodies that turn fast
    std::vector<std::uint32_t> others;    // awake bodies that do not
};

/// What holds for all sub-steps of a step of dt seconds.
SolverStep solverStep(WorldState& state, float dt);

/// Sums up how bodies answer to impulses; to be called before solveSubSteps().
void prepareContacts(WorldState& state, WorkerTeam& team, const SolverKernels& kernels, const SolverStep& step);
/// Moves all awake bodies through the step's sub-steps. Where they moved to is in their motions, not yet in their places.
void solveSubSteps(WorldState& state, WorkerTeam& team, SolveScratch& scratch, const SolverKernels& kernels,
                   const SolverStep& step);
/// Takes places over from motions.
void finishBodies(WorldState& state, WorkerTeam& team);

}  // namespace rubble
