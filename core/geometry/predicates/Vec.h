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

/// Twice the signed area of the triangle (0, a, b): positive if b is to the left of a. Rounded.
inline double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
/// The square of the length. Rounded.
inline double squaredLength(Vec2 a) { return a.x * a.x + a.y * a.y; }
/// The vector rotated by 90 degrees counter-clockwise.
inline Vec2 perpendicular(Vec2 a) { return {-a.y, a.x}; }

/// Orders points by x, then y, then z.
struct LexicographicLess {
    bool operator()(Vec2 a, Vec2 b) const { return a.x < b.x || (a.x == b.x && a.y < b.y); }
    bool operator()(Vec3 a, Vec3 b) const { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }
};
inline constexpr LexicographicLess lexicographicLess{};

/// The position and orientation of a local frame in its parent's.
struct Pose {
    Vec3 position{0.0, 0.0, 0.0};          // m
    Quat orientation{1.0, 0.0, 0.0, 0.0};  // parent from local
    bool operator==(const Pose&) const = default;
};

}  // namespace rubble
