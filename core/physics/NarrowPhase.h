#pragma once

#include "core/physics/Manifold.h"
#include "core/physics/Regions.h"
#include "core/physics/SolverKernels.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// What a look at two hulls gave.
struct Look {
    Manifold manifold;  // in the first hull's frame
    SeparatingAxis axis;
    Vec3f offset{0.0f, 0.0f, 0.0f};  // m: where the second's centre is then, in the first's frame
    bool isSwept = false;            // the manifold is of where they will meet
};

/// Where the second body is in the first's frame.
RelativePlace relativePlace(const BodyPlace& first, const BodyPlace& second);

/// Looks at two hulls as they are, or, where one moves far against its size, as they will be when they meet in the coming dt seconds.
Look lookAt(const WorldState& state, const Contact& contact, float dt);

struct Looked {
    std::uint32_t contact;
    Look look;
};

/// Memory that is used again from step to step.
struct LookScratch {
    std::vector<std::vector<Looked>> stale;  // by region
    std::vector<std::vector<Looked>> open;   // by chunk
    std::vector<const Looked*> all;          // ascending
};

/// Makes every manifold anew that is out of date, finds those of pairs that came near, and drops those of pairs that parted.
/// `newOnly` looks at contacts that were never looked at. Gives how many were looked at.
int findManifolds(WorldState& state, WorkerTeam& team, const Regions& regions, LookScratch& scratch,
                  const SolverKernels& kernels, const SolverStep& step, bool newOnly);

}  // namespace rubble
