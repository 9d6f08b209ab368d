#include "core/geometry/LinkedTriangles.h"

#include "core/geometry/Predicates.h"

#include <algorithm>
#include <compare>

namespace rubble {

namespace {

/// A half-edge under the name of its edge, whichever way it runs.
struct NamedHalfEdge {
    std::uint32_t low;
    std::uint32_t high;
    std::uint32_t halfEdge;
    auto operator<=>(const NamedHalfEdge&) const = default;
};

std::vector<NamedHalfEdge> byName(const LinkedTriangles& triangles) {
    std::vector<NamedHalfEdge> named(triangles.origin.size());
    for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge) {
        const std::uint32_t from = triangles.origin[halfEdge];
        const std::uint32_t to = triangles.origin[LinkedTriangles::next(halfEdge)];
        named[halfEdge] = {std::min(from, to), std::max(from, to), halfEdge};
    }
    std::sort(named.begin(), named.end());
    return named;
}

/// Swaps the diagonal of the two triangles at an inner half-edge a -> b with far corners c and d: c -> d instead.
void flip(LinkedTriangles& triangles, std::uint32_t halfEdge) {
    const auto join = [&](std::uint32_t first, std::uint32_t second) {
        triangles.twin[first] = second;
        if (second != LinkedTriangles::kBoundary) triangles.twin[second] = first;
    };
    const std::uint32_t other = triangles.twin[halfEdge];
    const std::uint32_t afterThis = LinkedTriangles::next(halfEdge), afterOther = LinkedTriangles::next(other);
    triangles.origin[afterThis] = triangles.origin[LinkedTriangles::previous(other)];
    triangles.origin[afterOther] = triangles.origin[LinkedTriangles::previous(halfEdge)];
    join(halfEdge, triangles.twin[afterOther]);
    join(other, triangles.twin[afterThis]);
    join(afterThis, afterOther);
}

}  // namespace

std::optional<LinkedTriangles> linked(const std::vector<CornerTriangle>& triangles, const NumberedCorners& corners) {
    LinkedTriangles result;
    result.origin.reserve(3 * triangles.size());
    for (const CornerTriangle& triangle : triangles)
        result.origin.insert(result.origin.end(), triangle.begin(), triangle.end());
    result.twin.assign(result.origin.size(), LinkedTriangles::kBoundary);

    const std::vector<NamedHalfEdge> named = byName(result);
    std::size_t boundaryCount = 0;
    for (std::size_t i = 0, end = 0; i < named.size(); i = end) {
        while (end < named.size() && named[end].low == named[i].low && named[end].high == named[i].high) ++end;
        const std::uint32_t halfEdge = named[i].halfEdge, other = named[end - 1].halfEdge;
        if (end - i == 1) {
            if (corners.next[result.origin[halfEdge]] != result.origin[LinkedTriangles::next(halfEdge)])
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

void makeDelaunay(LinkedTriangles& triangles, std::span<const Vec2> points) {
    const auto point = [&](std::uint32_t halfEdge) { return points[triangles.origin[halfEdge]]; };
    std::vector<std::uint32_t> open;
    for (std::uint32_t halfEdge = 0; halfEdge < triangles.halfEdgeCount(); ++halfEdge)
        if (triangles.twin[halfEdge] != LinkedTriangles::kBoundary && triangles.twin[halfEdge] > halfEdge)
            open.push_back(halfEdge);
    while (!open.empty()) {
        const std::uint32_t halfEdge = open.back(), other = triangles.twin[halfEdge];
        open.pop_back();
        if (other == LinkedTriangles::kBoundary) continue;
        const std::uint32_t after = LinkedTriangles::next(halfEdge), before = LinkedTriangles::previous(halfEdge);
        const std::uint32_t otherBefore = LinkedTriangles::previous(other);
        if (inCircle(point(halfEdge), point(after), point(before), point(otherBefore)) <= 0) continue;
        flip(triangles, halfEdge);
        open.insert(open.end(), {halfEdge, before, other, otherBefore});
    }
}

}  // namespace rubble
