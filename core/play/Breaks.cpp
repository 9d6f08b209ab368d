#include "core/play/Breaks.h"

#include <algorithm>

namespace rubble {
namespace {

/// The break of a body, or null where it stays whole.
PendingBreak* breakOf(BodyId body, std::span<PendingBreak> breaks) {
    const auto found = std::ranges::find(breaks, body, [](const PendingBreak& one) { return one.told.body.body; });
    return found == breaks.end() ? nullptr : &*found;
}

}  // namespace

void payForBreaks(World& world, std::span<PendingBreak> breaks) {
    for (PendingBreak& broken : breaks) {
        const PlayBreak& told = broken.told;
        if (told.striker.index == 0) continue;
        PendingBreak* other = breakOf(told.striker, breaks);
        const MovingMass striker = other != nullptr ? other->mass : movingMass(world, told.striker);
        const double most = stoppingImpulse(striker, broken.mass, told.point, told.normal, broken.restitution);
        const Vec3 impulse = std::min(told.threshold, most) * told.normal;
        broken.mass.push(impulse, told.point);
        if (other != nullptr) {
            other->mass.push(-impulse, told.point);
        } else if (striker.inverseMass > 0.0) {
            world.applyImpulse(told.striker, -impulse, told.point);
        }
    }
}

}  // namespace rubble
