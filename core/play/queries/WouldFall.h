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
    /// and straight along gravity; 0 where nothing drops by a centimetre. `last` is infinite where there is nothing
    /// below.
    double first = 0.0;
    double last = 0.0;
};

/// How long a query may take.
enum class QueryEffort {
    Quick,     // a few milliseconds at 1,000 bodies
    Thorough,  // as long as to play three seconds
};

/// The bodies at rest that come free if bodies (by number) are removed, since their support is gone, or that are
/// brought down by these. The session is not touched. A copy of its world is simulated by the steps of the session for
/// three seconds; what moves by more than 5 cm, or 5 % of its size if that is less, falls, and so does what breaks
/// whole. Fragments of what breaks do not come apart.
///
/// A quick query ends once 6,000 steps of single bodies were simulated: what is on its way then falls, what would rock
/// for longer is not reported. Where more than 160 bodies are connected by contacts, it simulates those that rest on
/// the removed ones and what touches these, for 0.15 s in coarse steps, and holds the rest in place: bodies that only
/// leaned on them, and what slides later, are missing.
///
/// A bonded body that anchors hold stays, as in play: it is anchored to places, also where a body was that is removed.
/// Mortar to what is removed breaks, and with it the hold of what reaches no other anchor.
///
/// O(n) for n bodies and their contacts, and the steps of those that are simulated.
/// Errors: BadInput for a number without a body, or the ground; those of World::addBody() in a quick query.
Result<Collapse> wouldFall(const Session& session, std::span<const std::uint32_t> removed,
                           QueryEffort effort = QueryEffort::Thorough);

/// The same where also fragments of bonded bodies may be removed, with all of their bonds. Of a held body come free, as
/// in play, the islands without an anchor and what is beyond the span, after its collapse delay; that it may find a
/// hold where it was does not count. Of a body that is not held, the islands are simulated like bodies.
///
/// Errors: BadInput also for a fragment that is not bonded in its body.
Result<Collapse> wouldFall(const Session& session, std::span<const BodyPart> removed,
                           QueryEffort effort = QueryEffort::Thorough);

}  // namespace rubble
