#pragma once

#include "core/geometry/HalfPlaneClip.h"
#include "core/geometry/HullOverlap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace rubble::test {

/// The corners seen from above that lie on one side of a body: those whose height along `axis` is greatest.
inline std::vector<Vec2> faceFromAbove(const std::vector<Vec3>& corners, Vec3 axis, double tolerance) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vec3& corner : corners) highest = std::max(highest, glm::dot(corner, axis));
    std::vector<Vec2> face;
    for (const Vec3& corner : corners) {
        if (glm::dot(corner, axis) >= highest - tolerance) face.emplace_back(corner.x, corner.z);
    }
    return face;
}

/// The lines through two of the points that have no point on their right: the hull's edges, each with its inside on
/// the left. Points as few as a body's corners need nothing faster.
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

/// How far inside the hull of the points a point lies, m; negative outside, or where there is no hull.
inline double depthInside(const std::vector<Vec2>& points, Vec2 point) {
    double depth = points.empty() ? -1.0 : std::numeric_limits<double>::infinity();
    for (const HalfPlane& side : hullSides(points)) depth = std::min(depth, side.offset - glm::dot(side.normal, point));
    return depth;
}

/// The points, which may also be two or one, in an order around their middle.
inline std::vector<Vec2> ringAround(std::vector<Vec2> points) {
    Vec2 centre(0.0);
    for (const Vec2 point : points) centre += point / static_cast<double>(points.size());
    std::sort(points.begin(), points.end(), [&](Vec2 a, Vec2 b) {
        return std::atan2(a.y - centre.y, a.x - centre.x) < std::atan2(b.y - centre.y, b.x - centre.x);
    });
    return points;
}

/// The part of a ring, or of a line there and back, on the inner side; a line stays one, as clipByHalfPlane() would not.
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

/// What two faces have in common, seen from above: nothing, a line or an area.
inline std::vector<Vec2> commonFromAbove(const std::vector<Vec2>& first, const std::vector<Vec2>& second) {
    const bool isSecondWide = second.size() > 2;
    std::vector<Vec2> common = ringAround(isSecondWide ? first : second);
    for (const HalfPlane& side : hullSides(isSecondWide ? second : first)) {
        common = clipped(common, {side.normal, side.offset + 1e-9});
    }
    return common;
}

/// Where a body rests on another, seen from above: empty unless they are at most `reach` apart and the lower one holds
/// the upper one up.
inline std::vector<Vec2> restingPoints(const Polytope& upper, const Pose& upperPose, const Polytope& lower,
                                       const Pose& lowerPose, double reach) {
    const HullOverlap overlap = hullOverlap(lower, lowerPose, upper, upperPose);
    if (overlap.depth < -reach || overlap.normal.y < 0.5) return {};
    const auto placed = [](const Polytope& body, const Pose& pose) {
        std::vector<Vec3> corners;
        for (const Vec3& vertex : body.vertices) corners.push_back(pose.position + pose.orientation * vertex);
        return corners;
    };
    return commonFromAbove(faceFromAbove(placed(lower, lowerPose), overlap.normal, reach),
                           faceFromAbove(placed(upper, upperPose), -overlap.normal, reach));
}

}  // namespace rubble::test
