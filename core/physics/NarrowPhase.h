#pragma once

#include "core/physics/Manifold.h"
#include "core/physics/SolverKernels.h"
#include "core/physics/WorkerTeam.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// What a look at two hulls gave.
struct Look {
    Manifold manifold;  // in the first hull's frame
    SeparatingAxis axis;
    Vec3f offset{0.0f, 0.0f, 0.0f};  // m: where the second's centre is then, in the first's frame
    bool isSwept = false;            // the manifold is of where they will meet
};

/// Looks at two hulls as they are, or, where one moves far against its size, as they will be when they meet in the coming dt seconds.
Look lookAt(const WorldState& state, const Contact& contact, float dt);

/// Memory that is used again from step to step.
struct LookScratch {
    std::vector<unsigned char> staleLanes;         // a bit a lane, by block in order of the colours
    std::vector<std::vector<std::uint32_t>> open;  // by chunk: contacts without manifold that may touch now
    std::vector<std::uint32_t> contacts;           // to look at
    std::vector<Look> looks;
};

/// Makes every manifold anew that is out of date, finds those of pairs that came near, and drops those of pairs that parted.
/// `newOnly` looks at contacts that were never looked at. Gives how many were looked at.
int findManifolds(WorldState& state, WorkerTeam& team, LookScratch& scratch, const SolverKernels& kernels,
                  const SolverStep& step, bool newOnly);

}  // namespace rubble
