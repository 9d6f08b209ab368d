#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Random.h"

namespace rubble::soak {

/// A scene whose parts are all about as large.
struct RandomScene {
    Project project;
    double size = 1.0;   // m: of its assets
    double speed = 3.0;  // m/s: of what falls by that, or a few m/s without gravity
};

/// A scene of assets of all kinds, placed, fixed, anchored and joined in all ways. It can be played.
RandomScene randomScene(Random& random);

}  // namespace rubble::soak
