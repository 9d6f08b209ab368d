#include "core/geometry/hull/MassProperties.h"

#include <array>
#include <cmath>

namespace rubble {

namespace {

/// The inertia tensor, from the integrals of products of two coordinates.
Mat3 inertiaFrom(double xx, double yy, double zz, double xy, double xz, double yz) {
    return Mat3{{yy + zz, -xy, -xz}, {-xy, xx + zz, -yz}, {-xz, -yz, xx + yy}};
}

double sixVolumes(Vec3 a, Vec3 b, Vec3 c) { return glm::dot(a, glm::cross(b, c)); }

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

/// The mass of what triangles enclose, some of whose points are `points`. `forEach(origin, visit)` calls visit(a, b, c)
/// for each, relative to an origin.
template <class ForEach>
MassProperties massWithin(std::span<const Vec3> points, const ForEach& forEach) {
    MassProperties mass;
    if (points.empty()) return mass;
    const Vec3 origin = points[0];
    double six = 0.0;
    Vec3 first{0.0, 0.0, 0.0};
    forEach(origin, [&](Vec3 a, Vec3 b, Vec3 c) {
        const double part = sixVolumes(a, b, c);
        six += part;
        first += part * (a + b + c);
    });
    mass.volume = six / 6.0;
    const bool isFlat = !(six > 0.0);
    mass.centre = isFlat ? meanOf(points) : origin + first / (4.0 * six);
    std::array<double, 6> products{};  // xx, yy, zz, xy, xz, yz
    forEach(mass.centre, [&](Vec3 a, Vec3 b, Vec3 c) {
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

/// combined() of `count` bodies that `part(k)` gives.
template <class Part>
MassProperties combinedParts(std::size_t count, const Part& part) {
    MassProperties whole;
    if (count == 0) return whole;
    const Vec3 origin = part(0).centre;
    Vec3 first{0.0, 0.0, 0.0};
    for (std::size_t k = 0; k < count; ++k) {
        whole.volume += part(k).volume;
        first += part(k).volume * (part(k).centre - origin);
    }
    whole.centre = whole.volume > 0.0 ? origin + first / whole.volume : origin;
    for (std::size_t k = 0; k < count; ++k) {
        const MassProperties& one = part(k);
        const Vec3 arm = one.centre - whole.centre;
        const Vec3 square = arm * arm;
        const Mat3 shift = inertiaFrom(square.x, square.y, square.z, arm.x * arm.y, arm.x * arm.z, arm.y * arm.z);
        whole.inertia += one.inertia + one.volume * shift;
    }
    return whole;
}

}  // namespace

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
    return massWithin(polytope.vertices,
                      [&](Vec3 origin, const auto& visit) { forEachTriangle(polytope, origin, visit); });
}

MassProperties massOf(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles) {
    return massWithin(points, [&](Vec3 origin, const auto& visit) {
        for (const auto& [a, b, c] : triangles) visit(points[a] - origin, points[b] - origin, points[c] - origin);
    });
}

MassProperties combined(std::span<const MassProperties> parts) {
    return combinedParts(parts.size(), [&](std::size_t k) -> const MassProperties& { return parts[k]; });
}

MassProperties combined(std::span<const MassProperties> bodies, std::span<const std::uint32_t> parts) {
    return combinedParts(parts.size(), [&](std::size_t k) -> const MassProperties& { return bodies[parts[k]]; });
}

}  // namespace rubble
