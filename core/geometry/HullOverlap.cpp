#include "core/geometry/HullOverlap.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <limits>

namespace rubble {

namespace {

/// What the axes are made of, and what is projected on them; in a frame common to both bodies.
struct Body {
    std::vector<Vec3> vertices;
    std::vector<Vec3> faceNormals;
    std::vector<Vec3> edgeDirections;  // parallel edges of equal length once, as the front's and the back's of a prism
};

bool isLess(Vec3 a, Vec3 b) {
    if (a.x != b.x) return a.x < b.x;
    return a.y != b.y ? a.y < b.y : a.z < b.z;
}

std::vector<Vec3> edgeDirections(const Polytope& polytope) {
    std::vector<Vec3> directions;
    directions.reserve(polytope.edges.size());
    for (const auto& [from, to] : polytope.edges) {
        const Vec3 along = polytope.vertices[to] - polytope.vertices[from];
        directions.push_back(isLess(along, Vec3(0.0)) ? -along : along);
    }
    std::sort(directions.begin(), directions.end(), isLess);
    directions.erase(std::unique(directions.begin(), directions.end()), directions.end());
    return directions;
}

/// The polytope turned, after `origin` was subtracted, and moved.
Body placed(const Polytope& polytope, Vec3 origin, const Mat3& rotation, Vec3 position) {
    Body body;
    body.edgeDirections = edgeDirections(polytope);
    for (Vec3& direction : body.edgeDirections) direction = rotation * direction;
    for (const Vec3& vertex : polytope.vertices) body.vertices.push_back(rotation * (vertex - origin) + position);
    for (const Plane& plane : polytope.planes) body.faceNormals.push_back(rotation * plane.normal);
    return body;
}

struct Interval {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Interval projected(const std::vector<Vec3>& points, Vec3 axis) {
    Interval interval;
    for (const Vec3& point : points) {
        const double height = glm::dot(point, axis);
        interval.low = std::min(interval.low, height);
        interval.high = std::max(interval.high, height);
    }
    return interval;
}

/// The axis of least depth so far.
class LeastDepth {
public:
    LeastDepth(const Body& first, const Body& second) : m_first(first), m_second(second) {}

    /// Tries an axis of length 1 both ways.
    void tryAxis(Vec3 axis) {
        const Interval a = projected(m_first.vertices, axis);
        const Interval b = projected(m_second.vertices, axis);
        keepLesser(a.high - b.low, axis);
        keepLesser(b.high - a.low, -axis);
    }
    HullOverlap result() const { return m_least; }

private:
    void keepLesser(double depth, Vec3 normal) {
        if (depth < m_least.depth) m_least = {depth, normal};
    }

    const Body& m_first;
    const Body& m_second;
    HullOverlap m_least{std::numeric_limits<double>::infinity(), {0.0, 1.0, 0.0}};
};

/// Every axis of length 1 along which two convex bodies that are apart may be seen to be.
template <class Function>
void forEachAxis(const Body& first, const Body& second, const Function& function) {
    for (const Vec3& normal : first.faceNormals) function(normal);
    for (const Vec3& normal : second.faceNormals) function(normal);
    for (const Vec3& a : first.edgeDirections) {
        for (const Vec3& b : second.edgeDirections) {
            const Vec3 axis = glm::cross(a, b);
            const double length = glm::length(axis);
            if (length > 0.0) function(axis / length);
        }
    }
}

struct BodyPair {
    Body first, second;
};

/// Both relative to the first body's first vertex: what is far from the origin keeps its digits.
BodyPair placed(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose) {
    RUBBLE_ASSERT(!first.vertices.empty() && !second.vertices.empty());
    const Mat3 firstRotation = glm::mat3_cast(firstPose.orientation);
    const Mat3 secondRotation = glm::mat3_cast(secondPose.orientation);
    const Vec3 origin = first.vertices[0];
    const bool isSameFrame = firstPose == secondPose;
    const Vec3 between = secondPose.position - firstPose.position;
    return {placed(first, origin, firstRotation, Vec3(0.0)),
            isSameFrame ? placed(second, origin, secondRotation, Vec3(0.0))
                        : placed(second, Vec3(0.0), secondRotation, between - firstRotation * origin)};
}

/// While the first body moves: the lengths of its way at which both overlap along every axis so far.
class OverlapAlong {
public:
    OverlapAlong(const BodyPair& bodies, Vec3 way, double tolerance)
        : m_bodies(bodies), m_way(way), m_tolerance(tolerance) {}

    void tryAxis(Vec3 axis) {
        const Interval a = projected(m_bodies.first.vertices, axis);
        const Interval b = projected(m_bodies.second.vertices, axis);
        const double pace = glm::dot(m_way, axis);
        const double slack = std::abs(pace) < kAcross ? m_tolerance : 0.0;
        const double toBegin = b.low - a.high + slack, toEnd = b.high - a.low - slack;
        if (std::abs(pace) < kAlmostNone) {
            m_meets = m_meets && toBegin < 0.0 && toEnd > 0.0;
            return;
        }
        m_from = std::max(m_from, std::min(toBegin / pace, toEnd / pace));
        m_to = std::min(m_to, std::max(toBegin / pace, toEnd / pace));
    }
    std::optional<double> touch() const {
        if (!m_meets || m_from >= m_to || m_to <= m_tolerance) return std::nullopt;
        return m_from;
    }

private:
    static constexpr double kAcross = 0.5;       // a slower pace along an axis is one past a side, not onto a face
    static constexpr double kAlmostNone = 1e-9;  // of the way's length: rounding

    const BodyPair& m_bodies;
    Vec3 m_way;
    double m_tolerance;
    bool m_meets = true;
    double m_from = -std::numeric_limits<double>::infinity();
    double m_to = std::numeric_limits<double>::infinity();
};

}  // namespace

HullOverlap hullOverlap(const Polytope& first, const Polytope& second) {
    return hullOverlap(first, Pose{}, second, Pose{});
}

HullOverlap hullOverlap(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose) {
    const BodyPair bodies = placed(first, firstPose, second, secondPose);
    LeastDepth least(bodies.first, bodies.second);
    forEachAxis(bodies.first, bodies.second, [&](Vec3 axis) { least.tryAxis(axis); });
    return least.result();
}

std::optional<double> distanceAlong(Vec3 way, const Polytope& first, const Pose& firstPose, const Polytope& second,
                                    const Pose& secondPose, double tolerance) {
    const BodyPair bodies = placed(first, firstPose, second, secondPose);
    OverlapAlong overlap(bodies, way, tolerance);
    forEachAxis(bodies.first, bodies.second, [&](Vec3 axis) { overlap.tryAxis(axis); });
    return overlap.touch();
}

}  // namespace rubble
