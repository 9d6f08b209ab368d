#include "core/geometry/polygon/BoundaryDistance.h"

#include "core/geometry/predicates/SegmentDistance.h"

#include <algorithm>

namespace rubble {
namespace {

double largest(const BoundaryDistance& boundary, const Polygon& polygon) {
    return std::max(boundary.largestOf(std::span(&polygon.outer, 1)), boundary.largestOf(polygon.holes));
}

}  // namespace

BoundaryDistance::BoundaryDistance(const Polygon& polygon) : m_edges(edgesOf(polygon)), m_tree(boxesOf(m_edges)) {}

double BoundaryDistance::of(Vec2 point) const {
    double nearest = 1e308;
    m_tree.visitNear(Vec3(point, 0.0), [&](std::uint32_t edge) {
        nearest = std::min(nearest, distanceToSegment(point, m_edges[edge][0], m_edges[edge][1]));
        return nearest;
    });
    return nearest;
}

double BoundaryDistance::largestOf(std::span<const Ring> rings) const {
    double farthest = 0.0;
    for (const Ring& ring : rings)
        for (const Vec2 point : ring) farthest = std::max(farthest, of(point));
    return farthest;
}

double distanceBetween(const Polygon& a, const Polygon& b) {
    return std::max(largest(BoundaryDistance(b), a), largest(BoundaryDistance(a), b));
}

}  // namespace rubble
