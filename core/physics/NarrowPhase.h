#pragma once

#include "core/physics/Manifold.h"
#include "core/physics/Regions.h"
#include "core/physics/SolverKernels.h"
#include "core/physics/WorldState.h"

namespace rubble {

/// Hulls nearer than this get a manifold before they touch, so that they do not overlap first.
inline constexpr float kSpeculativeDistance = 0.02f;  // m

/// Where the second body is in the first's frame.
RelativePlace relativePlace(const BodyPlace& first, const BodyPlace& second);

/// How two hulls touch, where they are not farther apart than `margin`. `guess` is the axis that was found before, and is kept as
/// long as no other can separate them by clearly more.
Look lookAlong(const Hull& first, const Hull& second, const RelativePlace& place, float margin,
               const SeparatingAxis& guess);

/// Looks at two hulls as they are, or, where one moves far against its size, as they will be when they meet in the coming dt seconds.
Look lookAt(const WorldState& state, const Contact& contact, float dt);

/// Writes what was seen into the lane of a contact that has one.
void keepManifold(WorldState& state, std::uint32_t contact, const Look& look);

/// Notes of a contact without manifold that it needs no look until its bodies have moved as far as they are apart.
void keepGap(WorldState& state, std::uint32_t contact, const Look& look);

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
