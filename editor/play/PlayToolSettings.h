#pragma once

#include "core/asset/project/Project.h"

namespace rubble {

/// The settings of the interactive tools of play.
struct PlayToolSettings {
    Throw projectile{.size = {0.6, 0.6, 0.6},
                     .mass = 200.0,
                     .speed = 22.0};  // its places say nothing; the speed is that of a full charge
    double hammerImpulse = 5000.0;    // N·s
    Explosion explosion{.impulse = 3000.0, .radius = 3.0};  // its place says nothing
    double grabForce = 20000.0;                             // N at most
    bool operator==(const PlayToolSettings&) const = default;
};

}  // namespace rubble
