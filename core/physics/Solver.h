#pragma once

#include "core/physics/Regions.h"
#include "core/physics/SolverKernels.h"
#include "core/physics/WorkerTeam.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// What the workers do side by side before they wait for each other: a pass over the contacts of a colour, or over bodies.
struct SolveStage {
    enum class Over : std::uint8_t { Contacts, Velocities, Positions, Grabbed };
    Over over = Over::Contacts;
    void (*pass)(std::span<ContactBlock>, const SolverStep&) = nullptr;
    std::uint32_t list = 0;  // the colour's first
};

/// Memory that is used again from step to step.
struct SolveScratch {
    std::vector<std::vector<std::uint32_t>> spinners;  // by region: bodies that turn fast
    std::vector<std::vector<std::uint32_t>> others;    // by region: awake bodies that do not
    std::vector<SolveStage> subStep;
    std::vector<SolveStage> restitution;
};

/// What holds for all sub-steps of a step of dt seconds.
SolverStep solverStep(WorldState& state, float dt);

/// Sums up how bodies answer to impulses; to be called before solveSubSteps().
void prepareContacts(WorldState& state, WorkerTeam& team, const Regions& regions, const SolverKernels& kernels,
                     const SolverStep& step);
/// Moves all awake bodies through the step's sub-steps. Where they moved to is in their motions, not yet in their places.
void solveSubSteps(WorldState& state, WorkerTeam& team, const Regions& regions, SolveScratch& scratch,
                   const SolverKernels& kernels, const SolverStep& step);
/// Takes places over from motions, and notes who rested in the step of dt seconds.
void finishBodies(WorldState& state, WorkerTeam& team, const Regions& regions, float dt);

}  // namespace rubble
