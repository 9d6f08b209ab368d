#pragma once

#include "core/geometry/Polygon.h"

namespace rubble {

/// How many times as long as wide an area is: a / b for a rectangle of sides a >= b and for an ellipse, 1 for all regular
/// polygons; the ratio of its principal radii of gyration. 1 where it has no area.
double aspectOf(const Polygon& polygon);

}  // namespace rubble
