#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <span>

namespace rubble {

/// The boolean difference of a polygon in canonical winding and some areas, each a simple counter-clockwise ring:
/// polygons in canonical winding, largest first. Remaining corners keep their bits; new ones are accurate to 2^-48 of
/// the polygon's extent.
/// Source: the Clipper library (Johnson).
std::vector<Polygon> difference(const Polygon& polygon, std::span<const Ring> removed);

}  // namespace rubble
