#include "core/geometry/NarrowPlaces.h"

#include "core/geometry/OutlineCleaning.h"
#include "core/geometry/PointFrame.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubble {

namespace {

using Kind = NarrowPlace::Kind;

bool isSharp(const NumberedCorners& corners, std::uint32_t corner, double sine) {
    const Vec2 ahead = corners.points[corners.next[corner]] - corners.points[corner];
    const Vec2 back = corners.points[corners.previous[corner]] - corners.points[corner];
    return glm::dot(ahead, back) > 0.0 && std::abs(cross(ahead, back)) <= sine * glm::length(ahead) * glm::length(back);
}

/// Edges and corners alone, without a look at others.
void addOwnPlaces(const NumberedCorners& corners, const Clearance& clearance, std::vector<NarrowPlace>& places) {
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner) {
        const std::uint32_t next = corners.next[corner];
        if (glm::distance(corners.points[corner], corners.points[next]) <= clearance.distance)
            places.push_back({corner, next, Kind::ShortEdge});
        else if (isSharp(corners, corner, clearance.sine))
            places.push_back({corner, corner, Kind::SharpCorner});
    }
}

/// Compares edges whose boxes come near to each other, in the order of their boxes' left sides.
class NearEdges {
public:
    NearEdges(const NumberedCorners& corners, double distance) : m_corners(corners), m_distance(distance) {
        for (std::uint32_t edge = 0; edge < corners.cornerCount(); ++edge) {
            Box2& box = m_boxes.emplace_back();
            box.include(corners.points[edge]);
            box.include(corners.points[corners.next[edge]]);
        }
    }

    void addPlaces(std::vector<NarrowPlace>& places) const {
        std::vector<std::uint32_t> order(m_boxes.size());
        std::iota(order.begin(), order.end(), 0u);
        std::ranges::sort(order, {}, [&](std::uint32_t edge) { return std::pair(m_boxes[edge].min.x, edge); });
        for (std::size_t i = 0; i < order.size(); ++i) {
            const Box2& box = m_boxes[order[i]];
            for (std::size_t j = i + 1; j < order.size(); ++j) {
                const Box2& other = m_boxes[order[j]];
                if (other.min.x - box.max.x > m_distance) break;
                if (other.min.y - box.max.y > m_distance || box.min.y - other.max.y > m_distance) continue;
                addNearCorners(order[i], order[j], places);
                addNearCorners(order[j], order[i], places);
            }
        }
    }

private:
    void addNearCorners(std::uint32_t edge, std::uint32_t other, std::vector<NarrowPlace>& places) const {
        const Vec2 from = m_corners.points[other], to = m_corners.points[m_corners.next[other]];
        for (const std::uint32_t corner : {edge, m_corners.next[edge]}) {
            if (corner == other || corner == m_corners.next[other]) continue;
            if (distanceFromEdge(m_corners.points[corner], from, to) <= m_distance)
                places.push_back({corner, other, Kind::CornerNearEdge});
        }
    }

    const NumberedCorners& m_corners;
    double m_distance;
    std::vector<Box2> m_boxes;  // of each edge
};

}  // namespace

Clearance clearanceOf(const Polygon& polygon) {
    const double distance = 4.0 * frameOf(polygon).joinDistance;
    return {distance, distance / (kVisiblePart * boundsOf(polygon.outer).diagonal())};
}

bool isClearlyWide(std::span<const Vec2> ring, const Clearance& clearance) {
    const double distance = 2.0 * clearance.distance, sine = 2.0 * clearance.sine;
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 here = ring[i], edge = ring[(i + 1) % count] - here, back = ring[(i + count - 1) % count] - here;
        const double length = glm::length(edge);
        const double nearest = std::min(cross(edge, back), cross(edge, ring[(i + 2) % count] - here));
        if (nearest <= distance * length) return false;  // beside a short edge, too
        if (glm::dot(edge, back) > 0.0 && cross(edge, back) <= sine * length * glm::length(back)) return false;
    }
    return true;
}

std::vector<NarrowPlace> narrowPlaces(const NumberedCorners& corners, const Clearance& clearance) {
    std::vector<NarrowPlace> places;
    addOwnPlaces(corners, clearance, places);
    const bool hasShortEdges =
        std::ranges::any_of(places, [](const NarrowPlace& place) { return place.kind == Kind::ShortEdge; });
    if (!hasShortEdges) NearEdges(corners, clearance.distance).addPlaces(places);
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
}

}  // namespace rubble
