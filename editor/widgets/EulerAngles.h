#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// The orientation after rotations by these angles about the world axes x, then y, then z: Blender's "XYZ Euler". Exact
/// for multiples of 90 degrees.
Quat orientationOf(Vec3 degrees);

/// The Euler angles of an orientation, rounded to 1e-10 degrees: x and z in (-180, 180], y in [-90, 90]. At gimbal
/// lock, y = ±90, z is 0.
Vec3 eulerDegrees(const Quat& orientation);

}  // namespace rubble
