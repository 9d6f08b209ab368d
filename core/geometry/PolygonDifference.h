#pragma once

#include "core/geometry/Polygon.h"

#include <span>

namespace rubble {

/// What is left of a canonical polygon without some areas, each a counter-clockwise ring that does not cross itself: canonical
/// polygons, the largest first. Corners that stay keep their bits; new ones are exact to 2^-48 of the polygon's extents.
/// Source: the difference of polygons is Clipper's.
std::vector<Polygon> difference(const Polygon& polygon, std::span<const Ring> removed);

}  // namespace rubble
