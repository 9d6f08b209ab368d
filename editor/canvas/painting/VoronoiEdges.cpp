#include "editor/canvas/painting/VoronoiEdges.h"

#include "core/geometry/line/SegmentClip.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// A point along a direction, outside the box.
Vec2 farAlong(Vec2 from, Vec2 direction, const Box2& box) {
    const double length = std::hypot(direction.x, direction.y);
    const Vec2 middle = (box.min + box.max) / 2.0;
    const double distance = box.diagonal() + std::hypot(from.x - middle.x, from.y - middle.y);
    return length > 0.0 ? from + direction * (2.0 * distance / length) : from;
}

/// The Voronoi edge dual to a half-edge.
std::optional<std::array<Vec2, 2>> dualOf(const Delaunay& delaunay, std::uint32_t halfEdge, const Box2& box) {
    const Vec2 a = delaunay.sites[delaunay.origin(halfEdge)];
    const Vec2 b = delaunay.sites[delaunay.origin(Delaunay::next(halfEdge))];
    const Vec2 left = perpendicular(b - a), middle = (a + b) / 2.0;
    const std::optional<Circle> here = circumcircle(delaunay, Delaunay::triangleOf(halfEdge));
    const std::optional<Circle> there = circumcircle(delaunay, Delaunay::triangleOf(delaunay.twin(halfEdge)));
    const Vec2 from = here ? here->centre : farAlong(there ? there->centre : middle, left, box);
    const Vec2 to = there ? there->centre : farAlong(here ? here->centre : middle, -left, box);
    return clippedTo(box, from, to);
}

}  // namespace

std::vector<std::array<Vec2, 2>> voronoiEdges(const Delaunay& delaunay, const Box2& box) {
    std::vector<std::array<Vec2, 2>> lines;
    for (std::uint32_t triangle = 0; triangle < delaunay.triangles.size(); ++triangle) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t halfEdge = 4 * triangle + k;
            const std::uint32_t from = delaunay.origin(halfEdge), to = delaunay.origin(Delaunay::next(halfEdge));
            if (from == kGhost || to == kGhost || from > to) continue;
            if (const auto line = dualOf(delaunay, halfEdge, box)) lines.push_back(*line);
        }
    }
    return lines;
}

std::optional<Circle> circumcircle(const Delaunay& delaunay, std::uint32_t triangle) {
    const Delaunay::Triangle& corners = delaunay.triangles[triangle];
    if (corners.isGhost()) return std::nullopt;
    const Vec2 a = delaunay.sites[corners.corner[0]];
    const Vec2 b = delaunay.sites[corners.corner[1]] - a, c = delaunay.sites[corners.corner[2]] - a;
    const double bb = b.x * b.x + b.y * b.y, cc = c.x * c.x + c.y * c.y;
    const Vec2 centre = perpendicular(b * cc - c * bb) / (2.0 * cross(b, c));
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return std::nullopt;
    return Circle{a + centre, std::hypot(centre.x, centre.y)};
}

}  // namespace rubble
