#pragma once

#include "core/play/Session.h"

#include <optional>
#include <vector>

namespace rubble {

/// A throw whose flight under a constant gravity, m/s^2, passes through a point: on the lower of the two arcs that do. Where it is
/// too slow to reach it, it is thrown straight at it.
Throw aimedAt(Throw thrown, Vec3 target, Vec3 gravity);

/// Where the middle of something thrown will fly.
struct Flight {
    std::vector<Vec3> points;   // m, one a step, the start first; the last where it is met
    std::optional<RayHit> hit;  // by what its middle meets first, of what is there now
};

/// Of a throw in the session as it is: until it meets something, at most for so many seconds.
Flight flightOf(const Session& session, const Throw& thrown, double seconds);

}  // namespace rubble
