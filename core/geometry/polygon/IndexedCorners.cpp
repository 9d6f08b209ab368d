#include "core/geometry/polygon/IndexedCorners.h"

#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <numeric>

namespace rubble {

namespace {

void append(IndexedCorners& corners, const Ring& ring) {
    const std::uint32_t first = corners.cornerCount();
    const auto count = static_cast<std::uint32_t>(ring.size());
    const std::uint32_t number = corners.ringCount();
    for (std::uint32_t i = 0; i < count; ++i) {
        corners.points.push_back(ring[i]);
        corners.next.push_back(first + (i + 1) % count);
        corners.previous.push_back(first + (i + count - 1) % count);
        corners.ring.push_back(number);
    }
    corners.firstOfRing.push_back(first + count);
}

}  // namespace

IndexedCorners indexedCorners(const Polygon& polygon) {
    IndexedCorners corners;
    corners.firstOfRing.push_back(0);
    std::size_t count = polygon.outer.size();
    for (const Ring& hole : polygon.holes) count += hole.size();
    corners.points.reserve(count);
    for (auto* numbers : {&corners.next, &corners.previous, &corners.ring}) numbers->reserve(count);
    append(corners, polygon.outer);
    for (const Ring& hole : polygon.holes) append(corners, hole);
    return corners;
}

std::vector<std::uint32_t> sweepOrder(const IndexedCorners& corners) {
    std::vector<std::uint32_t> order(corners.points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Vec2 pointA = corners.points[a], pointB = corners.points[b];
        return pointA == pointB ? a < b : lexicographicLess(pointA, pointB);
    });
    return order;
}

std::vector<SweptEdge> sweptEdges(const IndexedCorners& corners) {
    std::vector<SweptEdge> edges;
    edges.reserve(corners.cornerCount());
    for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner) {
        const Vec2 from = corners.points[corner], to = corners.points[corners.next[corner]];
        edges.push_back(lexicographicLess(from, to) ? SweptEdge{from, to, true} : SweptEdge{to, from, false});
    }
    return edges;
}

bool isBelow(const SweptEdge& a, const SweptEdge& b) {
    if (a.left == b.left) return orient2d(a.left, a.right, b.right) > 0;
    if (lexicographicLess(a.left, b.left)) return orient2d(a.left, a.right, b.left) > 0;
    return orient2d(b.left, b.right, a.left) < 0;
}

}  // namespace rubble
