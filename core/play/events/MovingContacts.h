#pragma once

#include "core/physics/world/World.h"

#include <vector>

namespace rubble {

/// A body that slides or rolls on another one, after a step.
struct MovingContact {
    bool isRolling = false;
    std::uint32_t body = 0;   // its number
    std::uint32_t other = 0;  // of the one that it slides or rolls on
    Vec3 point{0.0};          // m, in the world: the mean of where they touch, weighted by force
    double speed = 0.0;       // m/s: of the faces against each other; rolling: of the body's centre along the other
    double load = 0.0;        // N, that presses them together
};

/// The bodies of a session's world that slide or roll faster than 5 cm/s, each on what it rubs most: by load times
/// speed, which is at least 1 W; the `most` strongest, in order of their numbers. Rolling: the faces move against each
/// other at less than a quarter of the speed of the body's centre. O(n log n) for n contact points.
std::vector<MovingContact> movingContacts(const World& world, std::size_t most);

}  // namespace rubble
