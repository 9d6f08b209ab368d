#pragma once

#include "core/base/Random.h"
#include "core/geometry/polygon/Polygon.h"

#include <cmath>
#include <numbers>

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

/// The same with a hole of side 0.5 at the lower left.
inline Polygon lShapeWithHole() { return {lShape().outer, {reversed(rectangle({0.25, 0.25}, {0.75, 0.75}))}}; }

/// Four teeth, a hole, and points in the middle of straight edges.
inline Polygon combWithHole() {
    return {{{0, 0},
             {4, 0},
             {8, 0},
             {8, 4},
             {8, 8},
             {7, 8},
             {7, 1},
             {6, 1},
             {6, 8},
             {5, 8},
             {5, 1},
             {4, 1},
             {4, 8},
             {0, 8}},
            {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}}};
}

/// A ring whose corners alternate between two circles about a centre.
inline Ring star(std::uint32_t corners, double inner, double outer, Vec2 centre = {0.0, 0.0}) {
    Ring ring;
    for (std::uint32_t k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / corners, radius = k % 2 == 0 ? outer : inner;
        ring.push_back(centre + Vec2(std::cos(angle), std::sin(angle)) * radius);
    }
    return ring;
}

/// A ring of 3 to `most` random points of a square lattice.
inline Ring randomLatticeRing(Random& random, std::uint64_t most, std::uint64_t extent) {
    Ring ring(3 + random.below(most - 2));
    for (Vec2& point : ring)
        point = {static_cast<double>(random.below(extent)), static_cast<double>(random.below(extent))};
    return ring;
}

}  // namespace rubble
