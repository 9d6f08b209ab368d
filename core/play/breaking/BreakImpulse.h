#pragma once

#include "core/play/breaking/MovingMass.h"
#include "core/play/damage/InstanceDamage.h"
#include "core/play/state/SessionState.h"

#include <span>

namespace rubble {

/// A body about to be swapped: its break, and how its mass moves.
struct PendingBreak {
    PlayBreak event;
    double restitution = 0.0;                   // of the pair
    Pose pose;                                  // of the whole's frame
    MovingMass mass;                            // as if it were not fixed
    std::optional<ImpactCut> cut;               // instead of one at the point of impact
    std::shared_ptr<const PlayAsset> cutAsset;  // what it gives
};

/// Applies the break impulses, in order: each impactor loses, and the body it breaks gains, the body's threshold or the
/// impulse that stops their approach, whichever is less. If two bodies break each other, each is the other's impactor.
/// A break without an impactor gets no impulse. One that the world does not take is applied to neither, and reported;
/// each other one adds an entry to the energy audit of the session.
void applyBreakImpulses(SessionParts& parts, std::span<PendingBreak> breaks);

}  // namespace rubble
