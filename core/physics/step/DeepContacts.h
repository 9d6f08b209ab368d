#pragma once

#include "core/base/ThreadPool.h"
#include "core/physics/state/Regions.h"

namespace rubble {

/// A contact that overlaps beyond what is soft in all.
struct DeepContact {
    std::uint32_t contact = 0;
    std::uint32_t first = 0, second = 0;  // bodies
    Vec3f way{0.0f, 0.0f, 0.0f};          // m: of the second body, relative to the first
};

/// Displaces bodies that overlap deeply and hardly move, such as splinters that are jammed between others: friction
/// holds them against the springs of contacts. Call between prepareContacts(), whose separations are read, and
/// finishBodies(). `byRegion` is memory reused from step to step.
void displaceDeepContacts(WorldState& state, ThreadPool& threads, const Regions& regions, float dt,
                          std::vector<std::vector<DeepContact>>& byRegion);

}  // namespace rubble
