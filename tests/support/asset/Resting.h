#pragma once

#include "core/geometry/hull/HullOverlap.h"
#include "core/geometry/polygon/HalfPlaneClip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rubble::test {

/// The horizontal projection of the corners on one side of a body: those with the largest height along `axis`.
inline std::vector<Vec2> faceFromAbove(const std::vector<Vec3>& corners, Vec3 axis, double tolerance) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners) highest = std::max(highest, glm::dot(corner, axis));
    std::vector<Vec2> face;
    for (const Vec3& corner : corners) {
        if (glm::dot(corner, axis) >= highest - tolerance) face.emplace_back(corner.x, corner.z);
    }
    return face;
}

/// The edges of the points' convex hull as lines with the inside on their left. Quadratic, which is enough for a body's
/// corners.
inline std::vector<HalfPlane> hullSides(const std::vector<Vec2>& points) {
    std::vector<HalfPlane> sides;
    for (const Vec2 from : points) {
        for (const Vec2 to : points) {
            const double length = glm::distance(from, to);
            if (length < 1e-6) continue;
            const Vec2 outwards = -perpendicular(to - from) / length;
            const double offset = glm::dot(outwards, from);
            const bool isSide = std::all_of(points.begin(), points.end(),
                                            [&](Vec2 point) { return glm::dot(outwards, point) <= offset + 1e-9; });
            if (isSide) sides.push_back({outwards, offset});
        }
    }
    return sides;
}

/// The depth of a point inside the convex hull of the points, m; negative outside, or without a hull.
inline double depthInside(const std::vector<Vec2>& points, Vec2 point) {
    double depth = points.empty() ? -1.0 : std::numeric_limits<double>::infinity();
    for (const HalfPlane& side : hullSides(points)) depth = std::min(depth, side.offset - glm::dot(side.normal, point));
    return depth;
}

/// The points (one or more) ordered around their mean.
inline std::vector<Vec2> ringAround(std::vector<Vec2> points) {
    Vec2 centre(0.0);
    for (const Vec2 point : points) centre += point / static_cast<double>(points.size());
    std::sort(points.begin(), points.end(), [&](Vec2 a, Vec2 b) {
        return std::atan2(a.y - centre.y, a.x - centre.x) < std::atan2(b.y - centre.y, b.x - centre.x);
    });
    return points;
}

/// The part of a ring on the inner side of a line. Unlike clipByHalfPlane() it keeps degenerate rings.
inline std::vector<Vec2> clipped(const std::vector<Vec2>& ring, const HalfPlane& side) {
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 from = ring[i];
        const Vec2 to = ring[(i + 1) % ring.size()];
        const double fromInside = side.offset - glm::dot(side.normal, from);
        const double toInside = side.offset - glm::dot(side.normal, to);
        if (fromInside >= 0.0) kept.push_back(from);
        if ((fromInside > 0.0) != (toInside > 0.0)) {
            kept.push_back(from + (to - from) * (fromInside / (fromInside - toInside)));
        }
    }
    return kept;
}

/// The horizontal intersection of two faces: empty, a line or an area.
inline std::vector<Vec2> commonFromAbove(const std::vector<Vec2>& first, const std::vector<Vec2>& second) {
    const bool isSecondWide = second.size() > 2;
    std::vector<Vec2> common = ringAround(isSecondWide ? first : second);
    for (const HalfPlane& side : hullSides(isSecondWide ? second : first)) {
        common = clipped(common, {side.normal, side.offset + 1e-9});
    }
    return common;
}

/// The horizontal contact area of a body resting on another: empty if they are farther apart than `tolerance` or the
/// lower one does not support the upper one.
inline std::vector<Vec2> restingPoints(const Polytope& upper, const Pose& upperPose, const Polytope& lower,
                                       const Pose& lowerPose, double tolerance) {
    const HullOverlap overlap = hullOverlap(lower, lowerPose, upper, upperPose);
    if (overlap.depth < -tolerance || overlap.normal.y < 0.5) return {};
    const auto placed = [](const Polytope& body, const Pose& pose) {
        std::vector<Vec3> corners;
        for (const Vec3& vertex : body.vertices) corners.push_back(pose.position + pose.orientation * vertex);
        return corners;
    };
    return commonFromAbove(faceFromAbove(placed(lower, lowerPose), overlap.normal, tolerance),
                           faceFromAbove(placed(upper, upperPose), -overlap.normal, tolerance));
}

}  // namespace rubble::test
