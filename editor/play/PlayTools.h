#pragma once

#include "core/asset/Project.h"

namespace rubble {

/// What the user does things with while playing.
struct PlayTools {
    Throw thrown{.size = {0.6, 0.6, 0.6},
                 .mass = 200.0,
                 .speed = 22.0};                        // its places say nothing; the speed is that of a full charge
    double blow = 5000.0;                               // N s
    Explosion blast{.impulse = 3000.0, .radius = 3.0};  // its place says nothing
    double grip = 20000.0;                              // N at most
    bool operator==(const PlayTools&) const = default;
};

}  // namespace rubble
