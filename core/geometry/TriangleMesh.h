#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// Triangles over a list of points, as mesh files hold them; nothing is promised of their shape.
struct TriangleMesh {
    std::vector<Vec3> points;                             // m
    std::vector<std::array<std::uint32_t, 3>> triangles;  // indices of points
};

/// Twice the area of a triangle, along the way from which its corners run counter-clockwise.
Vec3 doubleArea(const TriangleMesh& mesh, std::size_t triangle);

/// An axis-aligned box; that of no points is empty (min > max).
struct Box3 {
    Vec3 min{1e308, 1e308, 1e308};
    Vec3 max{-1e308, -1e308, -1e308};
    void include(Vec3 point);
    void include(const Box3& box);
    bool isEmpty() const { return min.x > max.x; }
    Vec3 corner(int index) const;  // one of eight
    double diagonal() const;
    Vec3 centre() const { return min + (max - min) / 2.0; }
};
Box3 boundsOf(const TriangleMesh& mesh);

}  // namespace rubble
