#include "core/fracture/PieceRings.h"

#include "core/geometry/CornerSectors.h"
#include "core/geometry/Polygon.h"

#include <algorithm>

namespace rubble {

namespace {

Ring placesOf(const PieceRing& ring, std::span<const Vec2> points) {
    Ring places;
    for (const PieceCorner& corner : ring) places.push_back(points[corner.point]);
    return places;
}

bool meetInPoints(const std::vector<PieceRing>& rings) {
    std::vector<std::uint32_t> points;
    for (const PieceRing& ring : rings) {
        for (const PieceCorner& corner : ring) points.push_back(corner.point);
    }
    std::sort(points.begin(), points.end());
    return std::adjacent_find(points.begin(), points.end()) != points.end();
}

/// The same edges, joined so that each ring runs around one connected part of the area or around holes in it; as they
/// were where rounding has turned edges around a point out of order.
std::vector<PieceRing> partedBySectors(std::vector<PieceRing> rings, std::span<const Vec2> points) {
    Polygon polygon;
    PieceRing corners;
    for (const PieceRing& ring : rings) {
        corners.insert(corners.end(), ring.begin(), ring.end());
        polygon.holes.push_back(placesOf(ring, points));
    }
    polygon.outer.swap(polygon.holes[0]);
    polygon.holes.erase(polygon.holes.begin());
    NumberedCorners numbered = numberedCorners(polygon);
    if (!partSectors(numbered)) return rings;

    std::vector<PieceRing> parted;
    std::vector<bool> isTaken(corners.size(), false);
    for (std::uint32_t first = 0; first < corners.size(); ++first) {
        if (isTaken[first]) continue;
        PieceRing& ring = parted.emplace_back();
        for (std::uint32_t corner = first; !isTaken[corner]; corner = numbered.next[corner]) {
            isTaken[corner] = true;
            ring.push_back(corners[corner]);
        }
    }
    return parted;
}

/// Parts a ring that meets itself in points into rings that do not.
void partAtRepeatedPoints(PieceRing ring, std::vector<PieceRing>& parts) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        for (std::size_t j = i + 1; j < ring.size(); ++j) {
            if (ring[i].point != ring[j].point) continue;

            const auto begin = ring.begin() + static_cast<std::ptrdiff_t>(i);
            const auto end = ring.begin() + static_cast<std::ptrdiff_t>(j);
            PieceRing part(begin, end);
            ring.erase(begin, end);
            partAtRepeatedPoints(std::move(part), parts);
            j = i;
        }
    }
    if (ring.size() >= 3) parts.push_back(std::move(ring));
}

/// The part whose outer ring has a hole in it.
std::size_t partAround(const std::vector<PieceRings>& parts, const PieceRing& hole, std::span<const Vec2> points) {
    for (std::size_t part = 0; part + 1 < parts.size(); ++part) {
        const Polygon outer{placesOf(parts[part][0], points), {}};
        for (const PieceCorner& corner : hole) {
            const Containment place = containment(outer, points[corner.point]);
            if (place == Containment::Inside) return part;
            if (place == Containment::Outside) break;
        }
    }
    return parts.size() - 1;
}

}  // namespace

std::vector<PieceRings> connectedParts(std::vector<PieceRing> rings, std::span<const Vec2> points) {
    std::erase_if(rings, [](const PieceRing& ring) { return ring.size() < 3; });
    if (meetInPoints(rings)) rings = partedBySectors(std::move(rings), points);
    std::vector<PieceRings> parts;
    std::vector<PieceRing> looseHoles;
    for (PieceRing& ring : rings) {
        const std::size_t first = parts.size();
        std::vector<PieceRing> simple, holes;
        partAtRepeatedPoints(std::move(ring), simple);
        for (PieceRing& part : simple) {
            if (signedArea(placesOf(part, points)) > 0.0) {
                parts.push_back({std::move(part)});
            } else {
                holes.push_back(std::move(part));
            }
        }
        // Holes that touch the outer ring of a part are that part's.
        const bool isOnePart = parts.size() == first + 1;
        for (PieceRing& hole : holes) (isOnePart ? parts.back() : looseHoles).push_back(std::move(hole));
    }
    for (PieceRing& hole : looseHoles) {
        if (!parts.empty()) parts[partAround(parts, hole, points)].push_back(std::move(hole));
    }
    return parts;
}

}  // namespace rubble
