#pragma once

#include "core/geometry/predicates/Vec.h"

#include <algorithm>
#include <cmath>

namespace rubble {

/// The position of the point of a segment that is closest to `point`, as a fraction in [0, 1]; 0 for a segment of
/// length zero. For Vec2 and Vec3.
template <class Vector>
double closestFraction(Vector point, Vector from, Vector to) {
    const Vector along = to - from;
    const double squared = glm::dot(along, along);
    return squared > 0.0 ? std::clamp(glm::dot(point - from, along) / squared, 0.0, 1.0) : 0.0;
}

/// The distance of a point from a segment. The error is a few roundings of the longer of its offset and the segment.
template <class Vector>
double distanceToSegment(Vector point, Vector from, Vector to) {
    return glm::distance(point - from, closestFraction(point, from, to) * (to - from));
}

/// The distance of a point from a triangle in space.
inline double distanceToTriangle(Vec3 point, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 normal = glm::cross(b - a, c - a);
    const double size = glm::dot(normal, normal);
    const auto isLeft = [&](Vec3 from, Vec3 to) {
        return glm::dot(glm::cross(to - from, point - from), normal) >= 0.0;
    };
    if (size > 0.0 && isLeft(a, b) && isLeft(b, c) && isLeft(c, a))
        return std::abs(glm::dot(point - a, normal)) / std::sqrt(size);
    return std::min({distanceToSegment(point, a, b), distanceToSegment(point, b, c), distanceToSegment(point, c, a)});
}

}  // namespace rubble
