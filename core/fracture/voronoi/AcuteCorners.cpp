#include "core/fracture/voronoi/AcuteCorners.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {

AcuteCorners::AcuteCorners(const Polygon& outline, const LocalFrame& frame) : m_weldDistance(frame.weldDistance) {
    m_regions.reserve(outline.outer.size());
    addRing(outline.outer, frame);
    for (const Ring& hole : outline.holes) addRing(hole, frame);
}

void AcuteCorners::addRing(const Ring& ring, const LocalFrame& frame) {
    // Points on both edges that are welded to a third between them are at most twice the distance apart in x and in y.
    constexpr double kMaxWidth = 2.8284271247461903;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 corner = ring[i], next = ring[i + 1 < ring.size() ? i + 1 : 0];
        const Vec2 previous = ring[i > 0 ? i - 1 : ring.size() - 1];
        Region& region = m_regions.emplace_back();
        region.corner = corner - frame.origin;
        const Vec2 toNext = next - corner, toPrevious = previous - corner;
        if (glm::dot(toNext, toPrevious) <= 0.0) continue;
        region.ahead = glm::normalize(toNext);
        region.back = glm::normalize(toPrevious);
        const double sine = cross(region.ahead, region.back);
        if (sine > 0.0) region.length = kMaxWidth * m_weldDistance / sine;
        m_longest = std::max(m_longest, region.length);
    }
}

bool AcuteCorners::isIn(const Region& region, Vec2 point) const {
    const Vec2 offset = point - region.corner;
    return glm::dot(offset, offset) < region.length * region.length && cross(region.ahead, offset) >= -m_weldDistance &&
           cross(offset, region.back) >= -m_weldDistance;
}

}  // namespace rubble
