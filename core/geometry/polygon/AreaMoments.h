#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <span>

namespace rubble {

/// The area, centroid and second moments of a planar area.
struct AreaMoments {
    double area = 0.0;      // m²
    Vec2 centre{0.0, 0.0};  // m
    double xx = 0.0;        // m⁴: integrals of x², xy and y² about the centre
    double xy = 0.0;
    double yy = 0.0;
};

/// The moments of a polygon with holes, exact up to rounding. Inline, since it is called for every piece of a bake.
/// Source: Green's theorem on the outline; Mirtich 1996.
AreaMoments momentsOf(const Polygon& outline);

/// The integrals of 1 and of (x, y) over an area.
struct FirstIntegrals {
    double area = 0.0;
    Vec2 first{0.0, 0.0};

    /// Adds the integrals over the triangle (0, a, b), negated if it is clockwise.
    void addTriangle(Vec2 a, Vec2 b) {
        const double doubleArea = cross(a, b);
        area += doubleArea / 2.0;
        first += doubleArea / 6.0 * (a + b);
    }
    void addScaled(const FirstIntegrals& part, double factor) {
        area += factor * part.area;
        first += factor * part.first;
    }
};

/// The integrals of 1 and of (x², xy, y²) over an area.
struct SecondIntegrals {
    double area = 0.0;
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;

    void addTriangle(Vec2 a, Vec2 b) {
        const double doubleArea = cross(a, b);
        const Vec2 sum = a + b;
        area += doubleArea / 2.0;
        xx += doubleArea / 24.0 * (a.x * a.x + b.x * b.x + sum.x * sum.x);
        xy += doubleArea / 24.0 * (a.x * a.y + b.x * b.y + sum.x * sum.y);
        yy += doubleArea / 24.0 * (a.y * a.y + b.y * b.y + sum.y * sum.y);
    }
    void addScaled(const SecondIntegrals& part, double factor) {
        area += factor * part.area;
        xx += factor * part.xx;
        xy += factor * part.xy;
        yy += factor * part.yy;
    }
};

/// The sum over the triangles of `origin` and each edge of the ring, relative to the origin.
template <class Integrals>
Integrals integralsOver(std::span<const Vec2> ring, Vec2 origin) {
    Integrals integrals;
    if (ring.empty()) return integrals;
    Vec2 a = ring.back() - origin;
    for (const Vec2 corner : ring) {
        const Vec2 b = corner - origin;
        integrals.addTriangle(a, b);
        a = b;
    }
    return integrals;
}

/// The integrals over the outer ring minus those over the holes, for any winding.
template <class Integrals>
Integrals integralsOver(const Polygon& polygon, Vec2 origin) {
    Integrals sum = integralsOver<Integrals>(std::span(polygon.outer), origin);
    if (sum.area < 0.0) sum.addScaled(Integrals(sum), -2.0);
    for (const Ring& hole : polygon.holes) {
        const auto integrals = integralsOver<Integrals>(std::span(hole), origin);
        sum.addScaled(integrals, integrals.area < 0.0 ? 1.0 : -1.0);
    }
    return sum;
}

/// The mean of one or more points.
template <class Point>
Point meanOf(std::span<const Point> points) {
    Point sum{0.0};
    for (const Point& point : points) sum += (point - points[0]) / static_cast<double>(points.size());
    return points[0] + sum;
}

inline AreaMoments momentsOf(const Polygon& outline) {
    AreaMoments moments;
    if (outline.outer.empty()) return moments;
    const Vec2 origin = outline.outer[0];
    const auto about = integralsOver<FirstIntegrals>(outline, origin);
    moments.area = about.area;
    const bool isFlat = !(about.area > 0.0);
    moments.centre = isFlat ? meanOf(std::span<const Vec2>(outline.outer)) : origin + about.first / about.area;
    // A second pass relative to the centroid: moments about a distant origin would cancel.
    const auto central = integralsOver<SecondIntegrals>(outline, moments.centre);
    moments.xx = central.xx;
    moments.xy = central.xy;
    moments.yy = central.yy;
    return moments;
}

}  // namespace rubble
