#pragma once

#include "core/geometry/hull/MassProperties.h"
#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// The aspect ratio of an area, as the ratio of its principal radii of gyration: a / b for a rectangle or ellipse with
/// a >= b, 1 for a regular polygon. 1 for zero area.
double aspectRatio(const Polygon& polygon);

/// The same of a body: the ratio of its largest to its middle radius of gyration along its principal axes, so 1 for a
/// square plate. 1 for zero volume.
double aspectRatio(const MassProperties& body);

}  // namespace rubble
