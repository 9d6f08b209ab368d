#pragma once

#include "core/geometry/polygon/Polygon.h"
#include "tests/oracle/RationalConvex.h"

#include <array>
#include <vector>

namespace rubble::oracle {

/// A triangle of an outline, to the left of the lines of its sides.
struct OutlineTriangle {
    std::array<Line, 3> sides;
    std::array<std::size_t, 3> neighbours;  // triangle behind each side; kOutside: the side is part of the outline
    CGAL::Bbox_2 box;
    static constexpr std::size_t kOutside = static_cast<std::size_t>(-1);
};
using OutlineTriangles = std::vector<OutlineTriangle>;

/// Triangulates a valid outline without new corners, by CGAL's constrained Delaunay triangulation.
OutlineTriangles trianglesOf(const Polygon& outline);

}  // namespace rubble::oracle
