#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <cmath>

namespace rubble {

/// The width of an area, in m: twice the area divided by the perimeter, which is exact for long strips.
inline double widthOf(double area, double perimeter) { return 2.0 * area / perimeter; }
inline double widthOf(const Polygon& polygon) { return widthOf(area(polygon), perimeter(polygon)); }

/// Whether a polygon of this area is wider than `width`. Inline, because it is computed for every piece.
inline bool isWider(const Polygon& polygon, double area, double width);

inline bool isWider(const Polygon& polygon, double area, double width) {
    // The sum of a side's extents in x and y, which needs no root, bounds its length.
    double extents = 0.0;
    const auto addExtents = [&](const Ring& ring) {
        Vec2 from = ring.back();
        for (const Vec2 to : ring) {
            extents += std::abs(to.x - from.x) + std::abs(to.y - from.y);
            from = to;
        }
    };
    addExtents(polygon.outer);
    for (const Ring& hole : polygon.holes) addExtents(hole);
    constexpr double kSlack = 2.0;  // far above rounding
    return widthOf(area, kSlack * extents) > width || widthOf(area, perimeter(polygon)) > width;
}

}  // namespace rubble
