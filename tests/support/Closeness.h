#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace rubble {

/// Whether a value differs from the expected one by at most a fraction of it; by default, by a few roundings.
inline bool isNear(double value, double expected, double fraction = 1e-12) {
    return std::abs(value - expected) <= fraction * std::abs(expected);
}

/// Whether two points are at most a distance apart.
inline bool isWithinDistance(Vec2 a, Vec2 b, double distance) { return glm::distance(a, b) <= distance; }
inline bool isWithinDistance(Vec3 a, Vec3 b, double distance) { return glm::distance(a, b) <= distance; }

}  // namespace rubble
