#pragma once

#include "core/geometry/line/Box2.h"

#include <array>
#include <span>
#include <vector>

namespace rubble {

/// The corners of a closed polyline; the first is not repeated at the end.
using Ring = std::vector<Vec2>;

/// A polygon with holes. In canonical winding, the outer ring is counter-clockwise and holes are clockwise.
struct Polygon {
    Ring outer;
    std::vector<Ring> holes;
    bool operator==(const Polygon&) const = default;
};

/// The signed area of a ring: positive if counter-clockwise. Computed relative to its first corner, which keeps small
/// rings far from the origin accurate.
double signedArea(std::span<const Vec2> ring);
/// The area of the outer ring minus that of the holes, for any winding.
double area(const Polygon& polygon);
/// The centroid; the mean of the corners if the area is zero.
Vec2 centroid(const Polygon& polygon);
/// The length of the boundary, including holes.
double perimeter(std::span<const Vec2> ring);
double perimeter(const Polygon& polygon);
/// The corners of the outer ring and then of the holes.
std::vector<Vec2> cornersOf(const Polygon& polygon);
/// The edges of the outer ring and then of the holes, each from corner to corner along its ring.
std::vector<std::array<Vec2, 2>> edgesOf(const Polygon& polygon);
/// The bounding box.
Box2 boundsOf(std::span<const Vec2> points);

/// The polygon in canonical winding; first corners stay first. Exact for rings that do not cross or touch themselves.
Polygon withCanonicalWinding(Polygon polygon);

/// The position of a point relative to a polygon.
enum class Containment { Outside, OnBoundary, Inside };
/// The position of a point, decided exactly. O(n); for many points see ContainmentIndex.
Containment containment(const Polygon& polygon, Vec2 point);
/// Whether no corner of a counter-clockwise ring is reflex, decided exactly.
bool isConvex(std::span<const Vec2> ring);
/// Whether a ring is a convex polygon with counter-clockwise winding that goes around once, without zero angles: a
/// valid outline without holes. Decided exactly.
bool isSimpleAndConvex(std::span<const Vec2> ring);

}  // namespace rubble
