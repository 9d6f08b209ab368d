#pragma once

#include "core/fracture/delaunay/Delaunay.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <optional>
#include <vector>

namespace rubble {

/// The edges of the unclipped Voronoi diagram of a triangulation, clipped to a box. For drawing: not exact.
std::vector<std::array<Vec2, 2>> voronoiEdges(const Delaunay& delaunay, const Box2& box);

struct Circle {
    Vec2 centre{0.0, 0.0};
    double radius = 0.0;
};
/// The circumcircle of a triangle; none for a ghost triangle or one that is too flat.
std::optional<Circle> circumcircle(const Delaunay& delaunay, std::uint32_t triangle);

}  // namespace rubble
