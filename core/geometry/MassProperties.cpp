#include "core/geometry/MassProperties.h"

#include <array>
#include <cmath>

namespace rubble {

namespace {

/// Integrals over an area: of 1 and of (x, y).
struct FirstIntegrals {
    double area = 0.0;
    Vec2 first{0.0, 0.0};

    /// Adds those over the triangle (0, a, b), negative where it runs clockwise.
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

/// Integrals over an area: of 1 and of (x², xy, y²).
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

/// Integrals over the triangles between `origin` and the ring's edges, in coordinates relative to it.
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

/// The outer ring's integrals less the holes', whatever way the rings run.
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

/// Integrals of the products of two coordinates to the inertia tensor.
Mat3 inertiaFrom(double xx, double yy, double zz, double xy, double xz, double yz) {
    return Mat3{{yy + zz, -xy, -xz}, {-xy, xx + zz, -yz}, {-xz, -yz, xx + yy}};
}

/// Calls visit(a, b, c) for the triangles of every face, relative to `origin`.
template <class Visit>
void forEachTriangle(const Polytope& polytope, Vec3 origin, Visit visit) {
    for (const std::vector<std::uint32_t>& loop : polytope.faces) {
        const Vec3 a = polytope.vertices[loop[0]] - origin;
        for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
            visit(a, polytope.vertices[loop[k]] - origin, polytope.vertices[loop[k + 1]] - origin);
        }
    }
}

double sixVolumes(Vec3 a, Vec3 b, Vec3 c) { return glm::dot(a, glm::cross(b, c)); }

template <class Point>
Point meanOf(std::span<const Point> points) {
    Point sum{0.0};
    for (const Point& point : points) sum += (point - points[0]) / static_cast<double>(points.size());
    return points[0] + sum;
}

}  // namespace

AreaMoments momentsOf(const Polygon& outline) {
    AreaMoments moments;
    if (outline.outer.empty()) return moments;
    const Vec2 origin = outline.outer[0];
    const auto about = integralsOver<FirstIntegrals>(outline, origin);
    moments.area = about.area;
    const bool isFlat = !(about.area > 0.0);
    moments.centre = isFlat ? meanOf(std::span<const Vec2>(outline.outer)) : origin + about.first / about.area;
    // A second pass about the centre: the first one's integrals would cancel where the origin lies far from it.
    const auto central = integralsOver<SecondIntegrals>(outline, moments.centre);
    moments.xx = central.xx;
    moments.xy = central.xy;
    moments.yy = central.yy;
    return moments;
}

MassProperties massOfPrism(const AreaMoments& moments, double depth) {
    MassProperties mass;
    mass.volume = moments.area * depth;
    mass.centre = {moments.centre.x, moments.centre.y, 0.0};
    const double zz = mass.volume * depth * depth / 12.0;
    mass.inertia = inertiaFrom(moments.xx * depth, moments.yy * depth, zz, moments.xy * depth, 0.0, 0.0);
    return mass;
}

MassProperties massOfPrism(const Polygon& outline, double depth) { return massOfPrism(momentsOf(outline), depth); }

MassProperties massOf(const Polytope& polytope) {
    MassProperties mass;
    if (polytope.vertices.empty()) return mass;
    const Vec3 origin = polytope.vertices[0];
    double six = 0.0;
    Vec3 first{0.0, 0.0, 0.0};
    forEachTriangle(polytope, origin, [&](Vec3 a, Vec3 b, Vec3 c) {
        const double part = sixVolumes(a, b, c);
        six += part;
        first += part * (a + b + c);
    });
    mass.volume = six / 6.0;
    const bool isFlat = !(six > 0.0);
    mass.centre = isFlat ? meanOf(std::span<const Vec3>(polytope.vertices)) : origin + first / (4.0 * six);
    std::array<double, 6> products{};  // xx, yy, zz, xy, xz, yz
    forEachTriangle(polytope, mass.centre, [&](Vec3 a, Vec3 b, Vec3 c) {
        const double part = sixVolumes(a, b, c) / 120.0;
        const Vec3 sum = a + b + c;
        const auto add = [&](int i, int j) {
            return part * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + sum[i] * sum[j]);
        };
        products[0] += add(0, 0);
        products[1] += add(1, 1);
        products[2] += add(2, 2);
        products[3] += add(0, 1);
        products[4] += add(0, 2);
        products[5] += add(1, 2);
    });
    mass.inertia = inertiaFrom(products[0], products[1], products[2], products[3], products[4], products[5]);
    return mass;
}

MassProperties combined(std::span<const MassProperties> parts) {
    MassProperties whole;
    if (parts.empty()) return whole;
    const Vec3 origin = parts[0].centre;
    Vec3 first{0.0, 0.0, 0.0};
    for (const MassProperties& part : parts) {
        whole.volume += part.volume;
        first += part.volume * (part.centre - origin);
    }
    whole.centre = whole.volume > 0.0 ? origin + first / whole.volume : origin;
    for (const MassProperties& part : parts) {
        const Vec3 arm = part.centre - whole.centre;
        const Vec3 square = arm * arm;
        const Mat3 shift = inertiaFrom(square.x, square.y, square.z, arm.x * arm.y, arm.x * arm.z, arm.y * arm.z);
        whole.inertia += part.inertia + part.volume * shift;
    }
    return whole;
}

}  // namespace rubble
