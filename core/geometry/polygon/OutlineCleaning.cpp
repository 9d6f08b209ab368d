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

/// A rectangle around the corners of a run, along its direction. It shows for nearly all straight runs that no corner
/// is far from the line, without visiting each again for every corner that is added.
class RunBounds {
public:
    explicit RunBounds(const Box2& ring) : m_rounding(kRounding * (glm::length(ring.min) + glm::length(ring.max))) {}

    void restart(Vec2 from, Vec2 to) {
        const double length = glm::distance(from, to);
        m_origin = from;
        m_along = length > 0.0 ? (to - from) / length : Vec2(1.0, 0.0);
        m_box = {};
    }
    void add(Vec2 point) {
        const Vec2 offset = point - m_origin;
        m_box.include({glm::dot(offset, m_along), cross(m_along, offset)});
    }
    /// If so, the computed distance of each corner from the segment is at most `tolerance`. The distance is convex, so
    /// that it is largest at a corner of the rectangle.
    bool areSurelyNear(Vec2 from, Vec2 to, double tolerance) const {
        for (const Vec2 at : {m_box.min, m_box.max, Vec2(m_box.min.x, m_box.max.y), Vec2(m_box.max.x, m_box.min.y)}) {
            const Vec2 point = m_origin + at.x * m_along + at.y * Vec2(-m_along.y, m_along.x);
            if (!(distanceToSegment(point, from, to) <= tolerance - m_rounding)) return false;
        }
        return true;
    }

private:
    static constexpr double kRounding = 1e-13;  // of coordinates: hundreds of roundings of doubles

    double m_rounding;  // m
    Vec2 m_origin{0.0, 0.0}, m_along{1.0, 0.0};
    Box2 m_box;  // along and across
};

}  // namespace

std::vector<std::size_t> removeRepeatedPoints(Ring& ring) {
    std::size_t end = ring.size();
    while (end > 1 && ring[end - 1] == ring[0]) --end;
    std::vector<std::size_t> removed;
    Ring kept;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        if (i >= end || (i > 0 && ring[i] == ring[i - 1])) {
            removed.push_back(i);
        } else {
            kept.push_back(ring[i]);
        }
    }
    ring = std::move(kept);
    return removed;
}

Ring withoutCollinearCorners(std::span<const Vec2> ring, double tolerance, std::size_t* visited) {
    if (ring.size() < 3) return {};
    const Ring corners = fromFarthest(ring);
    const auto corner = [&](std::size_t i) { return corners[i % corners.size()]; };
    Ring kept{corners[0]};
    std::size_t start = 0, count = 0;
    RunBounds between(boundsOf(corners));
    between.restart(corner(0), corner(1));
    for (std::size_t end = 2; end <= corners.size(); ++end) {
        ++count;
        between.add(corner(end - 1));
        if (between.areSurelyNear(corner(start), corner(end), tolerance)) continue;
        bool isStraight = true;
        for (std::size_t i = start + 1; i < end && isStraight; ++i, ++count)
            isStraight = distanceToSegment(corner(i), corner(start), corner(end)) <= tolerance;
        if (isStraight) {  // bounded more tightly along the longer run
            between.restart(corner(start), corner(end));
            for (std::size_t i = start + 1; i < end; ++i) between.add(corner(i));
            continue;
        }
        start = end - 1;
        kept.push_back(corners[start]);
        between.restart(corner(start), corner(end));
    }
    if (visited) *visited += count;
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
