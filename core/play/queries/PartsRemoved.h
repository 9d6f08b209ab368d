#pragma once

#include "core/play/session/Session.h"

#include <span>
#include <vector>

namespace rubble {

/// A session from which fragments of bonded bodies were taken, while nothing has moved yet.
struct PartsRemoved {
    /// Those of the session, by their places in it, then what split off them. What is left of a body keeps its place.
    std::vector<PlayBody> bodies;
    World world;  // with the contacts of these bodies
    /// The number of the body in the session, for each that was split off: of bodies[k + count in the session].
    std::vector<std::uint32_t> splitOff;
    std::vector<std::uint32_t> reduced;  // numbers of the bodies that lost fragments or split, ascending
    std::vector<std::uint32_t> cameOff;  // indices of bodies, ascending: of held bodies, and no longer held
};

/// Takes parts out of a copy of a session: fragments of different bodies, ascending, and not all of any. The mortar of
/// these and of `gone`, numbers of bodies that stay in the copy, holds no longer. What has lost its support comes off
/// at once, see removeNodes().
PartsRemoved withoutParts(const Session& session, std::span<const BodyPart> parts,
                          std::span<const std::uint32_t> gone = {});

}  // namespace rubble
