#pragma once

#include "core/play/breaking/MovingMass.h"
#include "core/play/state/SessionState.h"

#include <string>

namespace rubble {

/// What the head of a hammer still has to give: an impulse, N·s, and an energy, J. It moves at kHammerSpeed and makes
/// nothing faster than that.
struct HammerHead {
    double impulse = 0.0;
    double energy = 0.0;

    /// A head that gives all its impulse when it stops.
    static HammerHead ofImpulse(double impulse);
    /// The impulse that it can give to a mass moving at `speed` m/s along the blow, N·s: at most what it has, what
    /// makes the mass as fast as the head, and what takes the head's energy.
    double impulseOn(double mass, double speed) const;
    /// Gives an impulse. Returns the work, J; negative for a mass that moves against the blow.
    double give(double given, double mass, double speed);
};

/// Applies a blow to the body that it hits. If it breaks, the whole takes the threshold's part, and the fragments under
/// the hammer the rest: all that the patch touches, and more in the order of their distance from the point that is hit,
/// until they can take it without getting faster than the hammer. All of them gain the same velocity. Of a body with
/// bonds, these take what they hold first; then what comes free takes the rest, or the body if nothing does. What moves
/// as fast as the hammer takes no more: what is left then is lost, and reported. A fixed body that stays whole takes
/// all.
void applyBlow(SessionParts& parts, const std::string& name, const Hammer& hammer);

}  // namespace rubble
