#include "core/geometry/hull/HullOverlap.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <limits>

namespace rubble {

namespace {

/// The vertices and axes of a body, in a common frame.
struct Body {
    std::vector<Vec3> vertices;
    std::vector<Vec3> faceNormals;
    std::vector<Vec3> edgeDirections;  // parallel edges of equal length once, such as those of a prism's caps
};

std::vector<Vec3> edgeDirections(const Polytope& polytope) {
    std::vector<Vec3> directions;
    directions.reserve(polytope.edges.size());
    for (const auto& [from, to] : polytope.edges) {
        const Vec3 along = polytope.vertices[to] - polytope.vertices[from];
        directions.push_back(lexicographicLess(along, Vec3(0.0)) ? -along : along);
    }
    std::sort(directions.begin(), directions.end(), lexicographicLess);
    directions.erase(std::unique(directions.begin(), directions.end()), directions.end());
    return directions;
}

/// The polytope relative to `origin`, rotated, then translated.
Body transformed(const Polytope& polytope, Vec3 origin, const Mat3& rotation, Vec3 position) {
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

Interval project(const std::vector<Vec3>& points, Vec3 axis) {
    Interval interval;
    for (const Vec3& point : points) {
        const double height = glm::dot(point, axis);
        interval.low = std::min(interval.low, height);
        interval.high = std::max(interval.high, height);
    }
    return interval;
}

/// The axis of least depth of those tested.
class LeastDepth {
public:
    LeastDepth(const Body& first, const Body& second) : m_first(first), m_second(second) {}

    /// Tests an axis of length 1 in both directions.
    void testAxis(Vec3 axis) {
        const Interval a = project(m_first.vertices, axis);
        const Interval b = project(m_second.vertices, axis);
        keepLess(a.high - b.low, axis);
        keepLess(b.high - a.low, -axis);
    }
    HullOverlap result() const { return m_least; }

private:
    void keepLess(double depth, Vec3 normal) {
        if (depth < m_least.depth) m_least = {depth, normal};
    }

    const Body& m_first;
    const Body& m_second;
    HullOverlap m_least{std::numeric_limits<double>::infinity(), {0.0, 1.0, 0.0}};
};

/// Calls function(axis) for every potential separating axis, of length 1.
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

/// Both bodies relative to the first one's first vertex, which keeps bodies far from the origin accurate.
BodyPair transformed(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose) {
    RUBBLE_ASSERT(!first.vertices.empty() && !second.vertices.empty());
    const Mat3 firstRotation = glm::mat3_cast(firstPose.orientation);
    const Mat3 secondRotation = glm::mat3_cast(secondPose.orientation);
    const Vec3 origin = first.vertices[0];
    const bool isSameFrame = firstPose == secondPose;
    const Vec3 between = secondPose.position - firstPose.position;
    return {transformed(first, origin, firstRotation, Vec3(0.0)),
            isSameFrame ? transformed(second, origin, secondRotation, Vec3(0.0))
                        : transformed(second, Vec3(0.0), secondRotation, between - firstRotation * origin)};
}

/// The interval of distances of the moving first body in which both overlap along every tested axis.
class OverlapInterval {
public:
    OverlapInterval(const BodyPair& bodies, Vec3 direction, double tolerance)
        : m_bodies(bodies), m_direction(direction), m_tolerance(tolerance) {}

    void testAxis(Vec3 axis) {
        const Interval a = project(m_bodies.first.vertices, axis);
        const Interval b = project(m_bodies.second.vertices, axis);
        const double speed = glm::dot(m_direction, axis);
        const double slack = std::abs(speed) < kSlidingSpeed ? m_tolerance : 0.0;
        const double toBegin = b.low - a.high + slack, toEnd = b.high - a.low - slack;
        if (std::abs(speed) < kZeroSpeed) {
            m_overlaps = m_overlaps && toBegin < 0.0 && toEnd > 0.0;
            return;
        }
        m_from = std::max(m_from, std::min(toBegin / speed, toEnd / speed));
        m_to = std::min(m_to, std::max(toBegin / speed, toEnd / speed));
    }
    std::optional<double> firstContact() const {
        if (!m_overlaps || m_from >= m_to || m_to <= m_tolerance) return std::nullopt;
        return m_from;
    }

private:
    static constexpr double kSlidingSpeed =
        0.5;  // relative; below, the body slides along the face rather than moving onto it
    static constexpr double kZeroSpeed = 1e-9;  // relative; below, it is rounding

    const BodyPair& m_bodies;
    Vec3 m_direction;
    double m_tolerance;
    bool m_overlaps = true;
    double m_from = -std::numeric_limits<double>::infinity();
    double m_to = std::numeric_limits<double>::infinity();
};

}  // namespace

HullOverlap hullOverlap(const Polytope& first, const Polytope& second) {
    return hullOverlap(first, Pose{}, second, Pose{});
}

HullOverlap hullOverlap(const Polytope& first, const Pose& firstPose, const Polytope& second, const Pose& secondPose) {
    const BodyPair bodies = transformed(first, firstPose, second, secondPose);
    LeastDepth least(bodies.first, bodies.second);
    forEachAxis(bodies.first, bodies.second, [&](Vec3 axis) { least.testAxis(axis); });
    return least.result();
}

std::optional<double> distanceAlong(Vec3 direction, const Polytope& first, const Pose& firstPose,
                                    const Polytope& second, const Pose& secondPose, double tolerance) {
    const BodyPair bodies = transformed(first, firstPose, second, secondPose);
    OverlapInterval overlap(bodies, direction, tolerance);
    forEachAxis(bodies.first, bodies.second, [&](Vec3 axis) { overlap.testAxis(axis); });
    return overlap.firstContact();
}

}  // namespace rubble
