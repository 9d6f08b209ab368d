#pragma once

#include "core/physics/shape/Hull.h"

namespace rubble {

/// The distance of a point from a hull, in the hull's frame, m; 0 inside. O(corners).
double distanceTo(const Hull& hull, Vec3 point);

}  // namespace rubble
