#pragma once

#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// A rectangle, counter-clockwise from its lower left corner.
inline Ring rectangle(Vec2 min, Vec2 max) { return {min, {max.x, min.y}, max, {min.x, max.y}}; }

inline Polygon unitSquare() { return {rectangle({0.0, 0.0}, {1.0, 1.0}), {}}; }

inline Ring reversed(const Ring& ring) { return {ring.rbegin(), ring.rend()}; }

/// A square of side 4 with a central hole of side 2.
inline Polygon squareRing() {
    return {rectangle({0.0, 0.0}, {4.0, 4.0}), {reversed(rectangle({1.0, 1.0}, {3.0, 3.0}))}};
}

/// A square of side 2 without its upper right quarter.
inline Polygon lShape() { return {{{0.0, 0.0}, {2.0, 0.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}}, {}}; }

}  // namespace rubble
