#pragma once

#include "core/geometry/Vec.h"

#include <span>
#include <vector>

namespace rubble {

/// The corners of a closed curve, the last joined to the first; the first is not repeated.
using Ring = std::vector<Vec2>;

/// An area with holes. Canonical: the outer ring counter-clockwise, every hole clockwise.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
    bool operator==(const Polygon&) const = default;
};

/// An axis-aligned box; empty (min > max) until it has been given a point.
struct Box2 {
    Vec2 min{1e308, 1e308};
    Vec2 max{-1e308, -1e308};
    void include(Vec2 point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    Vec2 size() const { return max - min; }
    double diagonal() const;
};

/// The area inside a ring: positive where it runs counter-clockwise. Computed relative to its
/// first corner, so that a small ring far from the origin keeps its digits.
double signedArea(std::span<const Vec2> ring);
/// The outer area less the holes', whatever way the rings run.
double area(const Polygon& polygon);
/// The centre of area; the mean of the corners where the area is zero.
Vec2 centroid(const Polygon& polygon);
double perimeter(std::span<const Vec2> ring);
double perimeter(const Polygon& polygon);  // with its holes'
Box2 boundsOf(std::span<const Vec2> points);

/// The same polygon with the outer ring counter-clockwise and the holes clockwise; first corners stay first.
/// Exact for rings that do not cross or touch themselves.
Polygon withCanonicalWinding(Polygon polygon);

enum class Containment { Outside, OnBoundary, Inside };
/// Where a point lies, decided exactly. Linear in the corners.
Containment containment(const Polygon& polygon, Vec2 point);
/// True where the corners of a counter-clockwise ring never turn right; decided exactly.
bool isConvex(std::span<const Vec2> ring);
/// True where a ring of usable points never turns right, goes round once and nowhere turns back on itself: a valid outline without
/// holes. Decided exactly.
bool isSimpleAndConvex(std::span<const Vec2> ring);

}  // namespace rubble
