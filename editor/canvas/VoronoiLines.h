#pragma once

#include "core/fracture/Delaunay.h"
#include "core/geometry/Polygon.h"

#include <array>
#include <optional>
#include <vector>

namespace rubble {

/// The edges of the whole Voronoi diagram of a triangulation, as far as they reach into a box. To be drawn: not exact.
std::vector<std::array<Vec2, 2>> voronoiLines(const Delaunay& delaunay, const Box2& box);

struct Circle {
    Vec2 centre{0.0, 0.0};
    double radius = 0.0;
};
/// The circle through a triangle's corners; none for a ghost and for one that is too flat to be drawn.
std::optional<Circle> circumcircle(const Delaunay& delaunay, std::uint32_t triangle);

/// The part of a segment that lies in a box; none where it misses it.
std::optional<std::array<Vec2, 2>> clippedTo(const Box2& box, Vec2 from, Vec2 to);

}  // namespace rubble
