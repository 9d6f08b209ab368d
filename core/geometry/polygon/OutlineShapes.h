#pragma once

#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// Primitive outlines, counter-clockwise, with the centre of the bounding box at the origin. Sizes in m, > 0.
Polygon rectangleOutline(double width, double height);
/// An isosceles triangle with a horizontal base at the bottom.
Polygon isoscelesTriangleOutline(double base, double height);
/// A regular polygon with at least 3 corners on a circle, with a horizontal lowest edge.
Polygon regularPolygonOutline(int corners, double diameter);

}  // namespace rubble
