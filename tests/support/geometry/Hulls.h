#pragma once

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/physics/shape/Hull.h"
#include "core/physics/shape/Shape.h"

#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace rubble::test {

/// A box about the origin.
inline Polytope boxOf(Vec3 sides) {
    const Vec3 half = 0.5 * sides;
    return extruded(std::vector<Vec2>{{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}},
                    -half.z, half.z);
}

inline Vec3 randomIn(Random& random, double half) {
    const double x = random.between(-half, half), y = random.between(-half, half);
    return {x, y, random.between(-half, half)};
}

/// A uniformly distributed random rotation.
/// Source: Shoemake 1992, "Uniform random rotations".
inline Quat randomRotation(Random& random) {
    const double fraction = random.unit();
    const double first = 2.0 * std::numbers::pi * random.unit();
    const double second = 2.0 * std::numbers::pi * random.unit();
    const double a = std::sqrt(1.0 - fraction);
    const double b = std::sqrt(fraction);
    return {b * cosine(second), a * sine(first), a * cosine(first), b * sine(second)};
}

/// A prism of 5 to 8 sides, as fragments are, or the hull of some points.
inline Polytope randomSolid(Random& random) {
    std::vector<Vec3> points;
    if (random.below(2) == 0) {
        while (points.size() < 12) points.push_back(randomIn(random, 0.3));
    } else {
        const auto sides = 5 + random.below(4);
        for (std::uint64_t i = 0; i < sides; ++i) {
            const double angle = 2.0 * std::numbers::pi * (static_cast<double>(i) + random.between(0.0, 0.8)) /
                                 static_cast<double>(sides);
            for (double z : {-0.25, 0.25}) points.push_back({0.3 * cosine(angle), 0.3 * sine(angle), z});
        }
    }
    return *convexHull(points);
}

/// How far a point is outside the nearest of hulls, m; 0 in one of them.
inline double distanceOutside(const std::vector<Polytope>& hulls, Vec3 point) {
    double nearest = 1e300;
    for (const Polytope& hull : hulls) {
        double outside = 0.0;
        for (const Plane& plane : hull.planes)
            outside = std::max(outside, glm::dot(plane.normal, point) - plane.offset);
        nearest = std::min(nearest, outside);
    }
    return nearest;
}

inline Hull hullOf(const Polytope& polytope) { return *makeHull(polytope, Vec3(0.0)); }

/// A shape of one box about the origin.
inline std::shared_ptr<const Shape> boxShape(Vec3 sides) { return *makeShape(std::vector{boxOf(sides)}); }

}  // namespace rubble::test
