#include "core/fracture/partition/PieceRings.h"

#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/polygon/TouchingCorners.h"

#include <algorithm>
#include <unordered_map>

namespace rubble {
namespace {

Ring positionsOf(const PieceRing& ring, std::span<const Vec2> points) {
    Ring positions;
    for (const PieceCorner& corner : ring) positions.push_back(points[corner.point]);
    return positions;
}

bool touchInPoints(const std::vector<PieceRing>& rings) {
    std::vector<std::uint32_t> points;
    for (const PieceRing& ring : rings) {
        for (const PieceCorner& corner : ring) points.push_back(corner.point);
    }
    std::sort(points.begin(), points.end());
    return std::adjacent_find(points.begin(), points.end()) != points.end();
}

/// The same edges, linked so that each ring bounds one connected part of the area or holes in it. Returns the rings
/// unchanged where rounding has put the edges around a point out of order.
std::vector<PieceRing> splitBySectors(std::vector<PieceRing> rings, std::span<const Vec2> points) {
    Polygon polygon;
    PieceRing corners;
    for (const PieceRing& ring : rings) {
        corners.insert(corners.end(), ring.begin(), ring.end());
        polygon.holes.push_back(positionsOf(ring, points));
    }
    polygon.outer.swap(polygon.holes[0]);
    polygon.holes.erase(polygon.holes.begin());
    IndexedCorners indexed = indexedCorners(polygon);
    if (!splitTouchingCorners(indexed)) return rings;

    std::vector<PieceRing> split;
    std::vector<bool> isVisited(corners.size(), false);
    for (std::uint32_t first = 0; first < corners.size(); ++first) {
        if (isVisited[first]) continue;
        PieceRing& ring = split.emplace_back();
        for (std::uint32_t corner = first; !isVisited[corner]; corner = indexed.next[corner]) {
            isVisited[corner] = true;
            ring.push_back(corners[corner]);
        }
    }
    return split;
}

bool touchesItself(const PieceRing& ring) {
    constexpr std::size_t kMaxCompared = 32;  // larger rings are sorted
    if (ring.size() > kMaxCompared) return touchInPoints({ring});
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (std::size_t j = i + 1; j < ring.size(); ++j) {
            if (ring[i].point == ring[j].point) return true;
        }
    }
    return false;
}

/// Splits a ring at the points in which it touches itself; inner parts come first. O(n log n), expected.
void splitAtRepeatedPoints(PieceRing ring, std::vector<PieceRing>& parts) {
    if (!touchesItself(ring)) {
        if (ring.size() >= 3) parts.push_back(std::move(ring));
        return;
    }
    PieceRing open;                                         // corners that are not in a part yet
    std::unordered_map<std::uint32_t, std::size_t> openAt;  // by point
    for (const PieceCorner& corner : ring) {
        if (const auto found = openAt.find(corner.point); found != openAt.end()) {
            const auto begin = open.begin() + static_cast<std::ptrdiff_t>(found->second);
            PieceRing part(begin, open.end());
            open.erase(begin, open.end());
            for (const PieceCorner& closed : part) openAt.erase(closed.point);
            if (part.size() >= 3) parts.push_back(std::move(part));
        }
        openAt.emplace(corner.point, open.size());
        open.push_back(corner);
    }
    if (open.size() >= 3) parts.push_back(std::move(open));
}

/// The part whose outer ring contains a hole.
std::size_t partAround(const std::vector<PieceRings>& parts, const PieceRing& hole, std::span<const Vec2> points) {
    for (std::size_t part = 0; part + 1 < parts.size(); ++part) {
        const Polygon outer{positionsOf(parts[part][0], points), {}};
        for (const PieceCorner& corner : hole) {
            const Containment place = containment(outer, points[corner.point]);
            if (place == Containment::Inside) return part;
            if (place == Containment::Outside) break;
        }
    }
    return parts.size() - 1;
}

}  // namespace

std::optional<RingEdge> findEdge(const PieceRings& rings, PointEdge edge) {
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        for (std::size_t corner = 0; corner < rings[ring].size(); ++corner) {
            const std::uint32_t end = rings[ring][nextCorner(rings[ring], corner)].point;
            if (PointEdge{rings[ring][corner].point, end} == edge) return RingEdge{ring, corner};
        }
    }
    return std::nullopt;
}

std::vector<PieceRings> connectedParts(std::vector<PieceRing> rings, std::span<const Vec2> points) {
    std::erase_if(rings, [](const PieceRing& ring) { return ring.size() < 3; });
    if (touchInPoints(rings)) rings = splitBySectors(std::move(rings), points);
    std::vector<PieceRings> parts;
    std::vector<PieceRing> looseHoles;
    for (PieceRing& ring : rings) {
        const std::size_t first = parts.size();
        std::vector<PieceRing> simple, holes;
        splitAtRepeatedPoints(std::move(ring), simple);
        for (PieceRing& part : simple) {
            if (signedArea(positionsOf(part, points)) > 0.0) {
                parts.push_back({std::move(part)});
            } else {
                holes.push_back(std::move(part));
            }
        }
        // Holes that touch the outer ring of a part belong to it.
        const bool isOnePart = parts.size() == first + 1;
        for (PieceRing& hole : holes) (isOnePart ? parts.back() : looseHoles).push_back(std::move(hole));
    }
    for (PieceRing& hole : looseHoles) {
        if (!parts.empty()) parts[partAround(parts, hole, points)].push_back(std::move(hole));
    }
    return parts;
}

}  // namespace rubble
