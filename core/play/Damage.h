#pragma once

#include "core/asset/Project.h"
#include "core/physics/World.h"

#include <span>

namespace rubble {

/// The worst that a step does to a body.
struct DamageDone {
    BodyId body;
    double amount = 0.0;       // N s, to be held against the threshold
    std::uint32_t impact = 0;  // that does it: an index in the impacts
};

/// By a rule, the damage that impacts do to every body that has part in one, in order of bodies' indices; of equal impacts
/// the first counts.
///
/// Rule Impact: the largest impact. Rule Momentum: at each impact, the larger of the body's own m |v| (1 - e) and the other's
/// m |v|, that of what never moves being none.
/// Source of the latter: the thesis, 4.4 and its listing 7, with velocities before solving.
std::vector<DamageDone> damageOf(std::span<const Impact> impacts, const World& world, DamageRule rule);

}  // namespace rubble
