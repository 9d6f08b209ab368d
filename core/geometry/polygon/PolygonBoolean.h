#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <span>

namespace rubble {

// Booleans of a polygon in canonical winding and areas, each a simple counter-clockwise ring. Remaining corners keep
// their bits; new ones are accurate to 2^-48 of the polygon's extent.
// Source: the Clipper library (Johnson).

/// The polygon without the areas: polygons in canonical winding, largest first.
std::vector<Polygon> difference(const Polygon& polygon, std::span<const Ring> removed);

/// The boundary of the polygon without an area, or with it: counter-clockwise rings around parts, clockwise ones around
/// holes. Corners of straight runs stay; edges along each other are recognized if they have the same corners. New
/// corners take the coordinates of corners that they share on the lattice.
std::vector<Ring> differenceBoundary(const Polygon& polygon, const Ring& removed);
std::vector<Ring> unionBoundary(const Polygon& polygon, const Ring& added);

}  // namespace rubble
