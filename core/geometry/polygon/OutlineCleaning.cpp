#include "core/geometry/polygon/OutlineCleaning.h"

#include "core/geometry/polygon/PolygonFaults.h"
#include "core/geometry/predicates/SegmentDistance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// The ring starting at its corner farthest from the first one, which is an extreme point and must be kept.
Ring fromFarthest(std::span<const Vec2> ring) {
    Ring rotated(ring.begin(), ring.end());
    const auto distance = [&](Vec2 point) { return glm::distance(point, ring[0]); };
    std::rotate(rotated.begin(), std::ranges::max_element(rotated, {}, distance), rotated.end());
    return rotated;
}

void startAtSmallest(Ring& ring) {
    std::rotate(ring.begin(), std::ranges::min_element(ring, lexicographicLess), ring.end());
}

}  // namespace

Ring withoutCollinearCorners(std::span<const Vec2> ring, double tolerance) {
    if (ring.size() < 3) return {};
    const Ring corners = fromFarthest(ring);
    const auto corner = [&](std::size_t i) { return corners[i % corners.size()]; };
    Ring kept{corners[0]};
    std::size_t start = 0;
    for (std::size_t end = 2; end <= corners.size(); ++end) {
        bool isStraight = true;
        for (std::size_t i = start + 1; i < end && isStraight; ++i)
            isStraight = distanceToSegment(corner(i), corner(start), corner(end)) <= tolerance;
        if (isStraight) continue;
        start = end - 1;
        kept.push_back(corners[start]);
    }
    if (kept.size() < 3) return {};
    return kept;
}

Result<Polygon> outlineOf(const std::vector<Ring>& rings, double tolerance) {
    std::vector<Ring> outer, holes;
    for (const Ring& ring : rings) {
        Ring corners = withoutCollinearCorners(ring, tolerance);
        if (corners.empty() || std::abs(signedArea(corners)) <= tolerance * perimeter(corners)) continue;
        std::vector<Ring>& list = signedArea(corners) > 0.0 ? outer : holes;
        list.push_back(std::move(corners));
    }
    if (outer.empty()) return Error{ErrorCode::Degenerate, "The outline encloses no area."};
    if (outer.size() > 1)
        return Error{ErrorCode::Degenerate, "The outline is in " + std::to_string(outer.size()) + " pieces."};
    return validated(fromSmallestCorners({std::move(outer[0]), std::move(holes)}));
}

Polygon fromSmallestCorners(Polygon polygon) {
    startAtSmallest(polygon.outer);
    std::ranges::for_each(polygon.holes, startAtSmallest);
    std::ranges::sort(polygon.holes, lexicographicLess, [](const Ring& ring) { return ring[0]; });
    return polygon;
}

}  // namespace rubble
