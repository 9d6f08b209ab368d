#include "core/physics/narrowphase/TimeOfImpact.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

// When a face touches flat, edges touch at the same time, up to rounding; the face is the contact. Edges must touch
// later by this distance to replace a face.
constexpr float kEdgeDelay = 5e-4f;     // m
constexpr float kEndTolerance = 1e-4f;  // m: a point this near to a hull's end along an axis counts as its end

struct Interval {
    float low = 0.0f;
    float high = 0.0f;
};

Interval projection(const Hull& hull, Vec3f direction) {
    const float start = dot(direction, hull.corner(0));
    Interval interval{start, start};
    for (int i = 1; i < hull.cornerCount; ++i) {
        const float along = dot(direction, hull.corner(i));
        interval.low = std::min(interval.low, along);
        interval.high = std::max(interval.high, along);
    }
    return interval;
}

/// The interval of time, as fractions of the displacement, in which the hulls overlap along every axis tested so far.
class OverlapTime {
public:
    OverlapTime(const Hull& first, const Hull& second, const RelativePose& pose, Vec3f displacement)
        : m_first(first), m_second(second), m_pose(pose), m_displacement(displacement) {}

    /// Intersects the interval with that of an axis. False if it becomes empty.
    bool narrow(const SeparatingAxis& axis) { return narrow(axis, m_pose.rotation.transposedTimes(axis.normal)); }
    /// The same of an axis whose direction in the second hull's frame is known: rounded twice, it would miss a far
    /// corner of a large face by more than a contact's depth.
    bool narrow(const SeparatingAxis& axis, Vec3f inSecond) {
        const Interval a = projection(m_first, axis.normal);
        Interval b = projection(m_second, inSecond);
        const float offset = dot(axis.normal, m_pose.offset), speed = dot(axis.normal, m_displacement);
        b = {b.low + offset, b.high + offset};
        // If other edges or corners lie farther out, the axis gives the time, but not the touching features.
        SeparatingAxis found = axis;
        if (b.low > a.high) {
            if (axis.kind == AxisKind::Edges && !areEnds(axis, a.high, b.low - offset)) found.kind = AxisKind::None;
            return narrowBothEnds(found, b.low - a.high, b.high - a.low, speed);
        }
        if (a.low > b.high) {
            found.normal = axis.normal * -1.0f;
            if (axis.kind != AxisKind::Edges || !areEnds(axis, a.low, b.high - offset)) {
                found.kind = AxisKind::None;
            }
            return narrowBothEnds(found, a.low - b.high, a.high - b.low, -speed);
        }
        return narrowEnd(b.high - a.low, a.high - b.low, speed);
    }

    TimeOfImpact timeOfImpact() const { return {m_axis, m_begin}; }
    bool isImpact() const { return m_axis.kind != AxisKind::None && m_begin <= m_end; }

private:
    /// Whether the two edges are the hulls' ends along the axis: of parallel edges only one is.
    bool areEnds(const SeparatingAxis& edges, float endOfFirst, float endOfSecond) const {
        const Vec3f first = m_first.corner(m_first.edges[edges.first].from);
        const Vec3f second = m_second.corner(m_second.edges[edges.second].from);
        return std::abs(dot(edges.normal, first) - endOfFirst) <= kEndTolerance &&
               std::abs(dot(m_pose.rotation.transposedTimes(edges.normal), second) - endOfSecond) <= kEndTolerance;
    }
    /// For a second hull `gap` ahead of the first along the normal, which has passed it after the distance `whole`.
    bool narrowBothEnds(const SeparatingAxis& axis, float gap, float whole, float speed) {
        if (speed >= 0.0f || gap > -speed) return false;
        const float begin = gap / -speed;
        const bool isOverFace = axis.kind == AxisKind::Edges && m_axis.kind != AxisKind::Edges;
        const float delay = isOverFace ? kEdgeDelay / -speed : 0.0f;
        const bool isLater = begin > m_axisBegin + delay || m_axis.kind == AxisKind::None;
        if (isLater && axis.kind != AxisKind::None) {
            m_axisBegin = begin;
            m_axis = axis;
            m_axis.separation = 0.0f;
        }
        m_begin = std::max(m_begin, begin);
        m_end = std::min(m_end, whole / -speed);
        return m_begin <= m_end;
    }
    bool narrowEnd(float backwards, float forwards, float speed) {
        if (speed < 0.0f) m_end = std::min(m_end, backwards / -speed);
        if (speed > 0.0f) m_end = std::min(m_end, forwards / speed);
        return m_begin <= m_end;
    }

    const Hull& m_first;
    const Hull& m_second;
    const RelativePose& m_pose;
    const Vec3f m_displacement;
    SeparatingAxis m_axis;  // along which they begin to overlap last
    float m_axisBegin = 0.0f;
    float m_begin = 0.0f;
    float m_end = 1.0f;
};

/// Whether the spheres around two hulls do not meet.
bool passesBy(const Hull& first, const Hull& second, Vec3f offset, Vec3f displacement) {
    constexpr float kMargin = 1.001f;  // for rounding
    const float square = lengthSquared(displacement);
    const float fraction = square > 0.0f ? std::clamp(-dot(offset, displacement) / square, 0.0f, 1.0f) : 0.0f;
    const float reach = (first.boundingRadius + second.boundingRadius) * kMargin;
    return lengthSquared(offset + displacement * fraction) > reach * reach;
}

}  // namespace

TimeOfImpact timeOfImpact(const Hull& first, const Hull& second, const RelativePose& pose, Vec3f displacement) {
    if (passesBy(first, second, pose.offset, displacement)) return {};
    OverlapTime overlap(first, second, pose, displacement);
    for (std::size_t face = 0; face < first.planes.size(); ++face) {
        const auto number = static_cast<std::uint16_t>(face);
        if (!overlap.narrow({AxisKind::FirstFace, number, 0, 0.0f, first.planes[face].normal})) return {};
    }
    for (std::size_t face = 0; face < second.planes.size(); ++face) {
        const auto number = static_cast<std::uint16_t>(face);
        const Vec3f inSecond = second.planes[face].normal * -1.0f;
        const Vec3f normal = pose.rotation * inSecond;
        if (!overlap.narrow({AxisKind::SecondFace, 0, number, 0.0f, normal}, inSecond)) return {};
    }
    for (std::size_t i = 0; i < first.edges.size(); ++i) {
        const Vec3f u = first.corner(first.edges[i].to) - first.corner(first.edges[i].from);
        for (std::size_t j = 0; j < second.edges.size(); ++j) {
            const Vec3f v = pose.rotation * (second.corner(second.edges[j].to) - second.corner(second.edges[j].from));
            const Vec3f axis = cross(u, v);
            if (lengthSquared(axis) <= 1e-4f * lengthSquared(u) * lengthSquared(v)) continue;
            const auto a = static_cast<std::uint16_t>(i), b = static_cast<std::uint16_t>(j);
            if (!overlap.narrow({AxisKind::Edges, a, b, 0.0f, normalized(axis)})) return {};
        }
    }
    return overlap.isImpact() ? overlap.timeOfImpact() : TimeOfImpact{};
}

}  // namespace rubble
