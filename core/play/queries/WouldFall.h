#pragma once

#include "core/play/session/Session.h"

#include <span>
#include <vector>

namespace rubble {

/// Bodies that come free together: they touch each other.
struct FallingIsland {
    std::vector<std::uint32_t> bodies;  // numbers, ascending
    double mass = 0.0;                  // kg, with that of the parts
    std::vector<BodyPart> parts = {};   // of bodies that fragments were removed from, ascending
};

/// What comes free where bodies are removed.
struct Collapse {
    std::vector<FallingIsland> islands;  // ascending first body
    double mass = 0.0;                   // kg, of all of them
    /// s, after the removal: when the first and the last of these bodies meets what stays below it, if it falls freely
    /// and straight along gravity; 0 where nothing falls. `last` is infinite where there is nothing below.
    double first = 0.0;
    double last = 0.0;
};

/// The bodies at rest that come free if bodies (by number) are removed, since their support is gone. The session is
/// not touched. A copy of its world is simulated for 0.15 s, in coarse steps: what its contacts do not hold moves by
/// then. What falling bodies hit later, or what rocks for longer before it falls, is not told. Where more than 160
/// bodies are connected by contacts, those that rest on the removed ones and what touches these is simulated, the rest
/// is held in place: bodies that only leaned on them may be missing.
///
/// A bonded body that anchors hold stays, as in play: it is anchored to places, also where a body was that is removed.
/// Mortar to what is removed breaks, and with it the hold of what reaches no other anchor.
///
/// O(n) for n bodies and their contacts, and the steps of those that are simulated.
/// Errors: BadInput for a number without a body, or the ground.
Result<Collapse> wouldFall(const Session& session, std::span<const std::uint32_t> removed);

/// The same where also fragments of bonded bodies may be removed, with all of their bonds. Of a held body come free, as
/// in play, the islands without an anchor and what is beyond the span, after its collapse delay; that it may find a
/// hold where it was does not count. Of a body that is not held, the islands are simulated like bodies.
///
/// Errors: BadInput also for a fragment that is not bonded in its body.
Result<Collapse> wouldFall(const Session& session, std::span<const BodyPart> removed);

}  // namespace rubble
