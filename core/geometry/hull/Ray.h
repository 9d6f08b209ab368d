#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// A half-line.
struct Ray {
    Vec3 from{0.0, 0.0, 0.0};
    Vec3 direction{0.0, 0.0, -1.0};  // length 1
    Vec3 at(double distance) const { return from + distance * direction; }
};

}  // namespace rubble
