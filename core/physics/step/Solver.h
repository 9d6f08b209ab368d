#pragma once

#include "core/base/ThreadPool.h"
#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/Regions.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/step/MassScaling.h"

namespace rubble {

/// A parallel stage between two barriers: a pass over the contacts of a colour, or over bodies.
struct SolveStage {
    enum class Over : std::uint8_t { Contacts, Velocities, Scaled, Positions, Grabbed, Thrown, Unbalanced };
    Over over = Over::Contacts;
    void (*pass)(std::span<ContactBlock>, const SolverStep&) = nullptr;
    std::uint32_t list = 0;  // the first of the colour's two lists
};

/// Memory of solveSubSteps(), reused from step to step.
struct SolveScratch {
    std::vector<std::vector<std::uint32_t>> fastRotating;  // by region
    std::vector<std::vector<std::uint32_t>> slowRotating;  // by region: the other awake bodies
    std::vector<std::vector<std::uint32_t>> thrown;        // by region: bodies that warm starting may have thrown
    std::vector<SolveStage> firstSubStep;
    std::vector<SolveStage> subStep;
    std::vector<SolveStage> restitution;
    std::vector<BlockList> unequalBlocks;  // by region, of prepareContacts(), in this step
    std::vector<BlockList> deepBlocks;     // the same
    std::vector<ScaledBody> scaled;        // of scaleMasses(), in this step
};

/// The parameters of a step of dt > 0 seconds.
SolverStep solverStep(WorldState& state, float dt);

/// Computes separations and effective masses, and finds the blocks that are unequal or deep (BlockTraits); call before
/// solveSubSteps().
void prepareContacts(WorldState& state, ThreadPool& threads, const Regions& regions, SolveScratch& scratch,
                     const SolverKernels& kernels, const SolverStep& step);
/// Solves the sub-steps of a step. The displacements are in the bodies' motions, not yet in their poses. `starts`, by
/// body: the velocities now; not needed without contacts.
void solveSubSteps(WorldState& state, ThreadPool& threads, const Regions& regions, SolveScratch& scratch,
                   const SolverKernels& kernels, const SolverStep& step, std::span<const StartMotion> starts);
/// Limits the angular velocities of what contacts have touched to kMaxSpin.
void limitSpins(WorldState& state, ThreadPool& threads, const Regions& regions);
/// Applies the displacements of a step of dt seconds to the poses, and updates rest times.
void finishBodies(WorldState& state, ThreadPool& threads, const Regions& regions, float dt);

}  // namespace rubble
