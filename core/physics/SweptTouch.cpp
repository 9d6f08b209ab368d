#include "core/physics/SeparatingAxis.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

// Of a face that meets flat, edges meet something at the same time, up to rounding; but what touches is the face. Edges must be
// later by so much of a way.
constexpr float kEdgesBehind = 5e-4f;  // m
constexpr float kOutermost = 1e-4f;    // m: what lies so near to the end of a hull along an axis is its end

struct Interval {
    float low = 0.0f;
    float high = 0.0f;
};

Interval spanAlong(const Hull& hull, Vec3f direction) {
    const float start = dot(direction, hull.corner(0));
    Interval span{start, start};
    for (int i = 1; i < hull.cornerCount; ++i) {
        const float along = dot(direction, hull.corner(i));
        span.low = std::min(span.low, along);
        span.high = std::max(span.high, along);
    }
    return span;
}

/// When the hulls overlap along every axis looked at so far.
class Overlap {
public:
    Overlap(const Hull& first, const Hull& second, const RelativePlace& place, Vec3f way)
        : m_first(first), m_second(second), m_place(place), m_way(way) {}

    /// False where they never overlap along this axis within the way.
    bool narrow(const SeparatingAxis& axis) {
        const Interval a = spanAlong(m_first, axis.normal);
        Interval b = spanAlong(m_second, m_place.turn.transposedTimes(axis.normal));
        const float offset = dot(axis.normal, m_place.offset), speed = dot(axis.normal, m_way);
        b = {b.low + offset, b.high + offset};
        // Where other edges or corners lie farther out, the axis tells when, but not what touches.
        SeparatingAxis found = axis;
        if (b.low > a.high) {
            if (axis.kind == AxisKind::Edges && !areOutermost(axis, a.high, b.low - offset))
                found.kind = AxisKind::None;
            return narrowOneSide(found, b.low - a.high, b.high - a.low, speed);
        }
        if (a.low > b.high) {
            found.normal = axis.normal * -1.0f;
            if (axis.kind != AxisKind::Edges || !areOutermost(axis, a.low, b.high - offset)) {
                found.kind = AxisKind::None;
            }
            return narrowOneSide(found, a.low - b.high, a.high - b.low, -speed);
        }
        return narrowEnd(b.high - a.low, a.high - b.low, speed);
    }

    SweptTouch touch() const { return {m_axis, m_begin}; }
    bool isMet() const { return m_axis.kind != AxisKind::None && m_begin <= m_end; }

private:
    /// Whether the two edges are what ends the hulls there: of parallel edges only one is.
    bool areOutermost(const SeparatingAxis& edges, float endOfFirst, float endOfSecond) const {
        const Vec3f first = m_first.corner(m_first.edges[edges.first].from);
        const Vec3f second = m_second.corner(m_second.edges[edges.second].from);
        return std::abs(dot(edges.normal, first) - endOfFirst) <= kOutermost &&
               std::abs(dot(m_place.turn.transposedTimes(edges.normal), second) - endOfSecond) <= kOutermost;
    }
    /// The second lies `gap` beyond the first along the normal, and has passed it after `whole`.
    bool narrowOneSide(const SeparatingAxis& axis, float gap, float whole, float speed) {
        if (speed >= 0.0f || gap > -speed) return false;
        const float begin = gap / -speed;
        const bool isOverFace = axis.kind == AxisKind::Edges && m_axis.kind != AxisKind::Edges;
        const float behind = isOverFace ? kEdgesBehind / -speed : 0.0f;
        const bool isLater = begin > m_axisBegin + behind || m_axis.kind == AxisKind::None;
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
    const RelativePlace& m_place;
    const Vec3f m_way;
    SeparatingAxis m_axis;  // along which they meet last
    float m_axisBegin = 0.0f;
    float m_begin = 0.0f;
    float m_end = 1.0f;
};

}  // namespace

SweptTouch sweptTouch(const Hull& first, const Hull& second, const RelativePlace& place, Vec3f way) {
    Overlap overlap(first, second, place, way);
    for (std::size_t face = 0; face < first.planes.size(); ++face) {
        const auto number = static_cast<std::uint16_t>(face);
        if (!overlap.narrow({AxisKind::FirstFace, number, 0, 0.0f, first.planes[face].normal})) return {};
    }
    for (std::size_t face = 0; face < second.planes.size(); ++face) {
        const auto number = static_cast<std::uint16_t>(face);
        const Vec3f normal = place.turn * second.planes[face].normal * -1.0f;
        if (!overlap.narrow({AxisKind::SecondFace, 0, number, 0.0f, normal})) return {};
    }
    for (std::size_t i = 0; i < first.edges.size(); ++i) {
        const Vec3f u = first.corner(first.edges[i].to) - first.corner(first.edges[i].from);
        for (std::size_t j = 0; j < second.edges.size(); ++j) {
            const Vec3f v = place.turn * (second.corner(second.edges[j].to) - second.corner(second.edges[j].from));
            const Vec3f axis = cross(u, v);
            if (lengthSquared(axis) <= 1e-4f * lengthSquared(u) * lengthSquared(v)) continue;
            const auto a = static_cast<std::uint16_t>(i), b = static_cast<std::uint16_t>(j);
            if (!overlap.narrow({AxisKind::Edges, a, b, 0.0f, normalized(axis)})) return {};
        }
    }
    return overlap.isMet() ? overlap.touch() : SweptTouch{};
}

}  // namespace rubble
