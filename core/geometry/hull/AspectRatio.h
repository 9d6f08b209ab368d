#pragma once

#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// The aspect ratio of an area, as the ratio of its principal radii of gyration: a / b for a rectangle or ellipse with
/// a >= b, 1 for a regular polygon. 1 for zero area.
double aspectRatio(const Polygon& polygon);

}  // namespace rubble
