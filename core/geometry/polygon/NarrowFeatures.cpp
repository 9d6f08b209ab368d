#include "core/geometry/polygon/NarrowFeatures.h"

#include "core/geometry/polygon/LocalFrame.h"
#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "core/geometry/search/BoxTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

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

/// The edges directly above and below each corner, by a sweep line.
class SweepNeighbours {
public:
    explicit SweepNeighbours(const IndexedCorners& corners)
        : m_corners(corners), m_edges(sweptEdges(corners)), m_status(IsBelow{&m_edges}) {
        m_entries.resize(m_edges.size(), m_status.end());
    }

    /// Whether visit(corner, edge) is true for one of them; the edges are not those of the corner.
    template <class Visit>
    bool anyOf(Visit visit) {
        for (const std::uint32_t corner : sweepOrder(m_corners)) {
            const Vec2 point = m_corners.points[corner];
            const std::array<std::uint32_t, 2> own{corner, m_corners.previous[corner]};
            for (const std::uint32_t edge : own) {
                if (m_edges[edge].right == point) m_status.erase(m_entries[edge]);
            }
            const auto above = m_status.lower_bound(point);
            if (above != m_status.end() && visit(corner, *above)) return true;
            if (above != m_status.begin() && visit(corner, *std::prev(above))) return true;
            for (const std::uint32_t edge : own) {
                if (m_edges[edge].left == point) m_entries[edge] = m_status.insert(edge).first;
            }
        }
        return false;
    }

private:
    /// Orders edges that do not cross from bottom to top where the sweep line is, and points among them.
    struct IsBelow {
        using is_transparent = void;
        const std::vector<SweptEdge>* edges;
        bool operator()(std::uint32_t first, std::uint32_t second) const {
            return first != second && isBelow((*edges)[first], (*edges)[second]);
        }
        bool operator()(std::uint32_t edge, Vec2 point) const {
            return orient2d((*edges)[edge].left, (*edges)[edge].right, point) > 0;
        }
        bool operator()(Vec2 point, std::uint32_t edge) const {
            return orient2d((*edges)[edge].left, (*edges)[edge].right, point) < 0;
        }
    };
    using Status = std::set<std::uint32_t, IsBelow>;

    const IndexedCorners& m_corners;
    std::vector<SweptEdge> m_edges;
    Status m_status;
    std::vector<Status::iterator> m_entries;  // of each edge in the status
};

/// Whether two corners are within a distance of each other.
bool hasNearCorners(const IndexedCorners& corners, double distance) {
    std::vector<Box3> boxes;
    boxes.reserve(corners.points.size());
    for (const Vec2 point : corners.points) boxes.push_back(boxOf(point, point));
    const BoxTree tree(boxes);
    bool isAny = false;
    const Vec3 margin(distance, distance, 0.0);
    for (std::uint32_t corner = 0; corner < boxes.size() && !isAny; ++corner) {
        tree.visitOverlapping({boxes[corner].min - margin, boxes[corner].max + margin},
                              [&](std::uint32_t other) { isAny |= other != corner; });
    }
    return isAny;
}

/// A sufficient test that no corner is within a distance of an edge that is not its own, in O(n log n) also where many
/// long edges run side by side, of which all boxes overlap.
///
/// If there are any, those at the least distance have no other edge between them. The corner either is within twice the
/// distance of an end of the edge, or lies beside its middle, and then the edge is the corner's neighbour along y or,
/// if it is steep, along x.
bool areEdgesApart(const IndexedCorners& corners, double distance) {
    const double ample = 1.1 * distance;  // above the rounding of distances
    if (hasNearCorners(corners, 2.0 * ample)) return false;
    IndexedCorners turned = corners;
    for (Vec2& point : turned.points) std::swap(point.x, point.y);
    for (const IndexedCorners* swept : {&corners, static_cast<const IndexedCorners*>(&turned)}) {
        const auto isNear = [&](std::uint32_t corner, std::uint32_t edge) {
            return distanceToSegment(swept->points[corner], swept->points[edge], swept->points[swept->next[edge]]) <=
                   ample;
        };
        if (SweepNeighbours(*swept).anyOf(isNear)) return false;
    }
    return true;
}

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
    if (!hasShortEdges && !areEdgesApart(corners, clearance.distance))
        NearEdges(corners, clearance.distance).addFeatures(features);
    std::ranges::sort(features);
    features.erase(std::unique(features.begin(), features.end()), features.end());
    return features;
}

}  // namespace rubble
