#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace rubble {

/// Points of a solid that are nearer to a plane than this times the diagonal of its box are in the plane: what is
/// thinner is lost when a solid is cut, too.
inline constexpr double kInPlane = 0x1p-38;

/// A plane through a solid, with axes for what is drawn in it. Its normal points up.
struct SectionPlane {
    Vec3 origin{0.0, 0.0, 0.0};  // m
    Vec3 x{1.0, 0.0, 0.0};       // of length 1
    Vec3 y{0.0, 1.0, 0.0};       // of length 1, perpendicular to x

    Vec3 normal() const { return glm::cross(x, y); }
    /// How far a point is above the plane, m; negative below it.
    double heightOf(Vec3 point) const { return glm::dot(point - origin, normal()); }
    /// A point, or what is above or below it, in the plane's axes, and back.
    Vec2 inPlane(Vec3 point) const { return {glm::dot(point - origin, x), glm::dot(point - origin, y)}; }
    Vec3 inSpace(Vec2 point) const { return origin + point.x * x + point.y * y; }
    /// The plane moved up.
    SectionPlane movedUp(double distance) const { return {origin + distance * normal(), x, y}; }
    bool isFinite() const {
        const Vec3 up = normal();
        return std::isfinite(origin.x + origin.y + origin.z + up.x + up.y + up.z);
    }
    bool operator==(const SectionPlane&) const = default;
};

/// The plane perpendicular to an axis (0, 1, 2 for x, y, z) at a coordinate. Its axes are the next two, in cyclic
/// order: x and y for z.
SectionPlane axisPlane(int axis, double coordinate);

/// The plane of a section at a coordinate along its axis, seen against that axis: y is up, or along z, into the depth,
/// where it is seen from above.
SectionPlane sectionPlane(int axis, double coordinate);

/// The plane through a point with a normal, of any length but zero. Its x axis is perpendicular to the coordinate axis
/// that the normal is the farthest from.
SectionPlane planeThrough(Vec3 point, Vec3 normal);

}  // namespace rubble
