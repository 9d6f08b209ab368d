#include "core/play/breaking/BreakImpulse.h"

#include "core/base/MessageText.h"
#include "core/play/state/InputDiagnostics.h"

#include <algorithm>

namespace rubble {
namespace {

/// The break of a body; null if it does not break.
PendingBreak* breakOf(BodyId body, std::span<PendingBreak> breaks) {
    const auto found =
        std::ranges::find(breaks, body, [](const PendingBreak& pending) { return pending.event.body.body; });
    return found == breaks.end() ? nullptr : &*found;
}

}  // namespace

void applyBreakImpulses(SessionParts& parts, std::span<PendingBreak> breaks) {
    for (PendingBreak& broken : breaks) {
        const PlayBreak& event = broken.event;
        if (event.impactor.index == 0) continue;
        PendingBreak* other = breakOf(event.impactor, breaks);
        const MovingMass impactor = other != nullptr ? other->mass : movingMass(parts.world(), event.impactor);
        const double stopping = stoppingImpulse(impactor, broken.mass, event.point, event.normal, broken.restitution);
        const Vec3 impulse = std::min(event.threshold, stopping) * event.normal;
        const std::string cause =
            "The hit that broke " + quotedName(nameOf(event.body, parts.state().origins[event.body.origin]));
        if (!isApplicable(parts, event.body, impulse, event.point, cause)) continue;
        EnergyEntry entry{.change = EnergyChange::BreakImpulse, .body = event.body.number};
        entry.before = impactor.kineticEnergy() + broken.mass.kineticEnergy();
        if (other != nullptr) {
            other->mass.applyImpulse(-impulse, event.point);
        } else if (impactor.inverseMass > 0.0) {
            applyImpulse(parts, event.impactor, -impulse, event.point, cause);
        }
        broken.mass.applyImpulse(impulse, event.point);
        const MovingMass slowed = other != nullptr ? other->mass : movingMass(parts.world(), event.impactor);
        entry.after = slowed.kineticEnergy() + broken.mass.kineticEnergy();
        parts.state().events.energy.push_back(entry);
    }
}

}  // namespace rubble
