#include "core/geometry/polygon/HalfEdgeTriangles.h"

#include "core/base/Index.h"

#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <compare>

namespace rubble {

namespace {

/// A half-edge with the corners of its edge, sorted.
struct SortedHalfEdge {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t halfEdge;
    auto operator<=>(const SortedHalfEdge&) const = default;
};

std::vector<SortedHalfEdge> sortedHalfEdges(const HalfEdgeTriangles& triangles) {
    std::vector<SortedHalfEdge> sorted(triangles.origin.size());
    for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge) {
        const std::uint32_t from = triangles.origin[halfEdge];
        const std::uint32_t to = triangles.origin[HalfEdgeTriangles::next(halfEdge)];
        sorted[halfEdge] = {std::min(from, to), std::max(from, to), halfEdge};
    }
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

/// Flips the inner edge a -> b of two triangles with opposite corners c and d to c -> d.
void flip(HalfEdgeTriangles& triangles, std::uint32_t halfEdge) {
    const auto join = [&](std::uint32_t first, std::uint32_t second) {
        triangles.twin[first] = second;
        if (second != kNone) triangles.twin[second] = first;
    };
    const std::uint32_t other = triangles.twin[halfEdge];
    const std::uint32_t afterThis = HalfEdgeTriangles::next(halfEdge), afterOther = HalfEdgeTriangles::next(other);
    triangles.origin[afterThis] = triangles.origin[HalfEdgeTriangles::previous(other)];
    triangles.origin[afterOther] = triangles.origin[HalfEdgeTriangles::previous(halfEdge)];
    join(halfEdge, triangles.twin[afterOther]);
    join(other, triangles.twin[afterThis]);
    join(afterThis, afterOther);
}

}  // namespace

std::optional<HalfEdgeTriangles> linkTriangles(const std::vector<CornerTriangle>& triangles,
                                               const IndexedCorners& corners) {
    HalfEdgeTriangles result;
    result.origin.reserve(3 * triangles.size());
    for (const CornerTriangle& triangle : triangles)
        result.origin.insert(result.origin.end(), triangle.begin(), triangle.end());
    result.twin.assign(result.origin.size(), kNone);

    const std::vector<SortedHalfEdge> sorted = sortedHalfEdges(result);
    std::size_t boundaryCount = 0;
    for (std::size_t i = 0, end = 0; i < sorted.size(); i = end) {
        while (end < sorted.size() && sorted[end].low == sorted[i].low && sorted[end].high == sorted[i].high) ++end;
        const std::uint32_t halfEdge = sorted[i].halfEdge, other = sorted[end - 1].halfEdge;
        if (end - i == 1) {
            if (corners.next[result.origin[halfEdge]] != result.origin[HalfEdgeTriangles::next(halfEdge)])
                return std::nullopt;
            ++boundaryCount;
        } else {
            if (end - i > 2 || result.origin[halfEdge] == result.origin[other]) return std::nullopt;
            result.twin[halfEdge] = other;
            result.twin[other] = halfEdge;
        }
    }
    if (boundaryCount != corners.points.size()) return std::nullopt;
    return result;
}

std::size_t makeDelaunay(HalfEdgeTriangles& triangles, std::span<const Vec2> points) {
    const auto point = [&](std::uint32_t halfEdge) { return points[triangles.origin[halfEdge]]; };
    std::size_t tested = 0;
    std::vector<std::uint32_t> open;
    for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge)
        if (triangles.twin[halfEdge] != kNone && triangles.twin[halfEdge] > halfEdge) open.push_back(halfEdge);
    while (!open.empty()) {
        const std::uint32_t halfEdge = open.back(), other = triangles.twin[halfEdge];
        open.pop_back();
        if (other == kNone) continue;
        ++tested;
        const std::uint32_t after = HalfEdgeTriangles::next(halfEdge), before = HalfEdgeTriangles::previous(halfEdge);
        const std::uint32_t otherBefore = HalfEdgeTriangles::previous(other);
        if (inCircle(point(halfEdge), point(after), point(before), point(otherBefore)) <= 0) continue;
        flip(triangles, halfEdge);
        open.insert(open.end(), {halfEdge, before, other, otherBefore});
    }
    return tested;
}

}  // namespace rubble
