#include "core/geometry/polygon/NarrowFeatures.h"

#include "core/geometry/polygon/LocalFrame.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "core/geometry/search/BoxTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

using Kind = NarrowFeature::Kind;

bool isSharp(const IndexedCorners& corners, std::uint32_t corner, double sine) {
    const Vec2 ahead = corners.points[corners.next[corner]] - corners.points[corner];
    const Vec2 back = corners.points[corners.previous[corner]] - corners.points[corner];
    return glm::dot(ahead, back) > 0.0 && std::abs(cross(ahead, back)) <= sine * glm::length(ahead) * glm::length(back);
}

/// Adds short edges and sharp corners.
void addLocalFeatures(const IndexedCorners& corners, const Clearance& clearance, std::vector<NarrowFeature>& features) {
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner) {
        const std::uint32_t next = corners.next[corner];
        if (glm::distance(corners.points[corner], corners.points[next]) <= clearance.distance)
            features.push_back({corner, next, Kind::ShortEdge});
        else if (isSharp(corners, corner, clearance.sine))
            features.push_back({corner, corner, Kind::SharpCorner});
    }
}

/// Finds the pairs of edges whose bounding boxes are near each other.
class NearEdges {
public:
    NearEdges(const IndexedCorners& corners, double distance) : m_corners(corners), m_distance(distance) {
        for (std::uint32_t edge = 0; edge < corners.cornerCount(); ++edge) {
            m_boxes.push_back(boxOf(corners.points[edge], corners.points[corners.next[edge]]));
        }
    }

    void addFeatures(std::vector<NarrowFeature>& features) const {
        const BoxTree tree(m_boxes);
        const Vec3 margin(2.0 * m_distance, 2.0 * m_distance, 0.0);  // twice: isNear() decides
        for (std::uint32_t edge = 0; edge < m_boxes.size(); ++edge) {
            const Box3 around{m_boxes[edge].min - margin, m_boxes[edge].max + margin};
            tree.visitOverlapping(around, [&](std::uint32_t other) {
                if (other <= edge || !isNear(m_boxes[edge], m_boxes[other])) return;
                addNearCorners(edge, other, features);
                addNearCorners(other, edge, features);
            });
        }
    }

private:
    bool isNear(const Box3& a, const Box3& b) const {
        return std::max(a.min.x, b.min.x) - std::min(a.max.x, b.max.x) <= m_distance &&
               std::max(a.min.y, b.min.y) - std::min(a.max.y, b.max.y) <= m_distance;
    }
    void addNearCorners(std::uint32_t edge, std::uint32_t other, std::vector<NarrowFeature>& features) const {
        const Vec2 from = m_corners.points[other], to = m_corners.points[m_corners.next[other]];
        for (const std::uint32_t corner : {edge, m_corners.next[edge]}) {
            if (corner == other || corner == m_corners.next[other]) continue;
            if (distanceToSegment(m_corners.points[corner], from, to) <= m_distance)
                features.push_back({corner, other, Kind::CornerNearEdge});
        }
    }

    const IndexedCorners& m_corners;
    double m_distance;
    std::vector<Box3> m_boxes;  // of each edge
};

}  // namespace

Clearance requiredClearance(const Polygon& polygon) {
    const double distance = 4.0 * localFrame(polygon).weldDistance;
    return {distance, distance / (kVisibleFraction * boundsOf(polygon.outer).diagonal())};
}

bool hasAmpleClearance(std::span<const Vec2> ring, const Clearance& clearance) {
    const double distance = 2.0 * clearance.distance, sine = 2.0 * clearance.sine;
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 here = ring[i], edge = ring[(i + 1) % count] - here, back = ring[(i + count - 1) % count] - here;
        const double length = glm::length(edge);
        const double nearest = std::min(cross(edge, back), cross(edge, ring[(i + 2) % count] - here));
        if (nearest <= distance * length) return false;  // also next to a short edge
        if (glm::dot(edge, back) > 0.0 && cross(edge, back) <= sine * length * glm::length(back)) return false;
    }
    return true;
}

std::vector<NarrowFeature> narrowFeatures(const IndexedCorners& corners, const Clearance& clearance) {
    std::vector<NarrowFeature> features;
    addLocalFeatures(corners, clearance, features);
    const bool hasShortEdges =
        std::ranges::any_of(features, [](const NarrowFeature& feature) { return feature.kind == Kind::ShortEdge; });
    if (!hasShortEdges) NearEdges(corners, clearance.distance).addFeatures(features);
    std::ranges::sort(features);
    features.erase(std::unique(features.begin(), features.end()), features.end());
    return features;
}

}  // namespace rubble
