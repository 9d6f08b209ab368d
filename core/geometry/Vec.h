#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace rubble {

using Vec2 = glm::dvec2;
using Vec3 = glm::dvec3;
using Mat3 = glm::dmat3;  // column-major, as GLM
using Quat = glm::dquat;  // unit, w first

/// Twice the signed area of the triangle (0, a, b): positive where b is left of a. Rounded.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// The vector turned a quarter to the left.
inline Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

/// Where a local frame stands in its parent's.
struct Pose {
    Vec3 position{0.0, 0.0, 0.0};          // m
    Quat orientation{1.0, 0.0, 0.0, 0.0};  // parent from local
    bool operator==(const Pose&) const = default;
};

}  // namespace rubble
