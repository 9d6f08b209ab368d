#pragma once

#include "core/geometry/Vec.h"

namespace rubble {

/// From a point, one way on.
struct Ray {
    Vec3 from{0.0, 0.0, 0.0};
    Vec3 direction{0.0, 0.0, -1.0};  // length 1
    Vec3 at(double distance) const { return from + distance * direction; }
};

}  // namespace rubble
