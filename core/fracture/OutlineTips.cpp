#include "core/fracture/OutlineTips.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {

OutlineTips::OutlineTips(const Polygon& outline, const PointFrame& frame) : m_joinDistance(frame.joinDistance) {
    m_tips.reserve(outline.outer.size());
    addRing(outline.outer, frame);
    for (const Ring& hole : outline.holes) addRing(hole, frame);
}

void OutlineTips::addRing(const Ring& ring, const PointFrame& frame) {
    // Points on both edges that are one with a third between them lie within twice the distance in x and in y.
    constexpr double kWidest = 2.8284271247461903;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 corner = ring[i], next = ring[i + 1 < ring.size() ? i + 1 : 0];
        const Vec2 previous = ring[i > 0 ? i - 1 : ring.size() - 1];
        Tip& tip = m_tips.emplace_back();
        tip.corner = corner - frame.origin;
        const Vec2 toNext = next - corner, toPrevious = previous - corner;
        if (glm::dot(toNext, toPrevious) <= 0.0) continue;
        tip.ahead = glm::normalize(toNext);
        tip.back = glm::normalize(toPrevious);
        const double sine = cross(tip.ahead, tip.back);
        if (sine > 0.0) tip.length = kWidest * m_joinDistance / sine;
        m_longest = std::max(m_longest, tip.length);
    }
}

bool OutlineTips::isIn(const Tip& tip, Vec2 point) const {
    const Vec2 offset = point - tip.corner;
    return glm::dot(offset, offset) < tip.length * tip.length && cross(tip.ahead, offset) >= -m_joinDistance &&
           cross(offset, tip.back) >= -m_joinDistance;
}

}  // namespace rubble
