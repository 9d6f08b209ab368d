#pragma once

#include "core/play/session/Session.h"

#include <span>
#include <vector>

namespace rubble {

/// Fragments whose centre is at most this far from where the project placed it stand, m.
inline constexpr double kStandingDistance = 0.1;

/// What of an instance stands.
struct StandingParts {
    double volume = 0.0;                   // m³
    std::vector<std::uint32_t> fragments;  // of the bake, ascending, those of a solid that has not broken included
};

/// The parts of an instance that are at most kStandingDistance from where the project placed them. O(bodies and their
/// fragments).
StandingParts standingParts(const Session& session, Id instance);

/// The width of the largest hole in a bonded instance, m: of the fragments of its first level that do not stand, sets
/// that share faces, directly or through others of the set; the width of one is the largest distance between two of
/// its corners, seen along z, see diameterOf(). 0 if all stand.
double holeWidth(const PlayStructure& structure, std::span<const std::uint32_t> standing);

}  // namespace rubble
