#pragma once

#include "core/geometry/Vec.h"

namespace rubble {

/// An orientation as three turns about the axes of the world: first about x, then y, then z, in degrees, as Blender's
/// "XYZ". Right angles give exact orientations.
Quat orientationOf(Vec3 degrees);

/// The turns that give an orientation: x and z in (-180, 180], y in [-90, 90]; z is 0 where x and z turn about the same
/// axis. For reading: rounded to what a turn of a body can mean.
Vec3 eulerDegrees(const Quat& orientation);

}  // namespace rubble
