#include "core/geometry/polygon/OutlineShapes.h"

#include "core/base/Assert.h"
#include "core/base/math/Trigonometry.h"

#include <numbers>

namespace rubble {

Polygon rectangleOutline(double width, double height) {
    const double x = width / 2.0, y = height / 2.0;
    return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, {}};
}

Polygon isoscelesTriangleOutline(double base, double height) {
    const double x = base / 2.0, y = height / 2.0;
    return {{{-x, -y}, {x, -y}, {0.0, y}}, {}};
}

Polygon regularPolygonOutline(int corners, double diameter) {
    RUBBLE_ASSERT(corners >= 3);
    const double step = kFullTurn / corners;
    const double first = -std::numbers::pi / 2.0 - step / 2.0;
    Polygon polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = first + k * step;
        polygon.outer.push_back(diameter / 2.0 * Vec2{cosine(angle), sine(angle)});
    }
    const Box2 bounds = boundsOf(polygon.outer);
    for (Vec2& corner : polygon.outer) corner -= (bounds.min + bounds.max) / 2.0;
    return polygon;
}

}  // namespace rubble
