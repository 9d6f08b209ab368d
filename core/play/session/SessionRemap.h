#pragma once

#include "core/play/session/Session.h"

#include <string>
#include <vector>

namespace rubble {

/// The damage of one scene for another, and what got lost.
struct RemappedSession {
    SessionDamage damage;
    std::vector<std::string> losses;  // a sentence each, by ascending instance
};

/// Maps the damage of a session to another version of its scene: by the ids of instances and the paths of fragments,
/// which stay as long as their seeds do. See remappedDamage().
///
/// Errors: those of cutAtImpact().
Result<RemappedSession> remappedSession(const Session& session, const PlayScene& to);

}  // namespace rubble
