#include "core/geometry/OutlineCleaning.h"

#include "core/geometry/PolygonFaults.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

bool isBefore(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

double distanceFromRing(const Ring& ring, Vec2 point) {
    double nearest = 1e308;
    for (std::size_t i = 0; i < ring.size(); ++i)
        nearest = std::min(nearest, distanceFromEdge(point, ring[i], ring[(i + 1) % ring.size()]));
    return nearest;
}

/// The ring from its corner farthest from the first one: surely a corner that must stay.
Ring fromFarthest(std::span<const Vec2> ring) {
    Ring turned(ring.begin(), ring.end());
    const auto distance = [&](Vec2 point) { return glm::distance(point, ring[0]); };
    std::rotate(turned.begin(), std::ranges::max_element(turned, {}, distance), turned.end());
    return turned;
}

void beginAtSmallest(Ring& ring) { std::rotate(ring.begin(), std::ranges::min_element(ring, isBefore), ring.end()); }

}  // namespace

Ring withoutStraightCorners(std::span<const Vec2> ring, double tolerance) {
    if (ring.size() < 3) return {};
    const Ring corners = fromFarthest(ring);
    const auto corner = [&](std::size_t i) { return corners[i % corners.size()]; };
    Ring kept{corners[0]};
    std::size_t start = 0;
    for (std::size_t end = 2; end <= corners.size(); ++end) {
        bool isStraight = true;
        for (std::size_t i = start + 1; i < end && isStraight; ++i)
            isStraight = distanceFromEdge(corner(i), corner(start), corner(end)) <= tolerance;
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
        Ring corners = withoutStraightCorners(ring, tolerance);
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
    beginAtSmallest(polygon.outer);
    std::ranges::for_each(polygon.holes, beginAtSmallest);
    std::ranges::sort(polygon.holes, isBefore, [](const Ring& ring) { return ring[0]; });
    return polygon;
}

double distanceFromEdge(Vec2 point, Vec2 from, Vec2 to) {
    const Vec2 along = to - from, offset = point - from;
    const double squared = glm::dot(along, along);
    const double share = squared > 0.0 ? std::clamp(glm::dot(offset, along) / squared, 0.0, 1.0) : 0.0;
    return glm::distance(offset, share * along);
}

double distanceFromBoundary(const Polygon& polygon, Vec2 point) {
    double nearest = distanceFromRing(polygon.outer, point);
    for (const Ring& hole : polygon.holes) nearest = std::min(nearest, distanceFromRing(hole, point));
    return nearest;
}

double distanceFromBoundary(const Polygon& polygon, const std::vector<Ring>& rings) {
    double farthest = 0.0;
    for (const Ring& ring : rings)
        for (const Vec2 point : ring) farthest = std::max(farthest, distanceFromBoundary(polygon, point));
    return farthest;
}

double distanceBetween(const Polygon& a, const Polygon& b) {
    return std::max({distanceFromBoundary(b, {a.outer}), distanceFromBoundary(b, a.holes),
                     distanceFromBoundary(a, {b.outer}), distanceFromBoundary(a, b.holes)});
}

}  // namespace rubble
