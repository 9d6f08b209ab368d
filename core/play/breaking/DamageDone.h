#pragma once

#include "core/asset/project/Project.h"
#include "core/physics/world/World.h"

#include <span>

namespace rubble {

/// The largest damage that a step does to a body.
struct DamageDone {
    BodyId body;
    double amount = 0.0;       // N·s, compared with the threshold
    std::uint32_t impact = 0;  // index of the impact that causes it
};

/// The damage by a rule to every body with an impact, by body index; if several impacts are equal, the first.
///
/// Rule Impact: the largest impact. Rule Momentum: for each impact, the larger of the body's own m |v| (1 - e) and the
/// other's m |v|, which is 0 for static bodies.
/// Source of rule Momentum: "Creating Realistic Real-Time Destruction Using the Vienna Physics Engine" (bachelor
/// thesis), 4.4 and listing 7, with velocities before solving.
std::vector<DamageDone> damageOf(std::span<const Impact> impacts, const World& world, DamageRule rule);

}  // namespace rubble
