#pragma once

#include "core/geometry/Polygon.h"

namespace rubble {

/// Outlines to start from, counter-clockwise, with the middle of their bounding box at the origin. Sizes in m, > 0.
Polygon rectangleOutline(double width, double height);
/// Base below, tip above.
Polygon isoscelesTriangleOutline(double base, double height);
/// 3 or more corners on a circle, the lowest side level.
Polygon regularPolygonOutline(int corners, double diameter);

}  // namespace rubble
