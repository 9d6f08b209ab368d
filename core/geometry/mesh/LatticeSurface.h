#pragma once

#include "core/geometry/mesh/TriangleMesh.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A closed, consistently oriented surface of triangles on a SolidLattice. Half-edge 3t + k runs from corner k of
/// triangle t to the next one.
struct LatticeSurface {
    /// A view along an axis in which a triangle has an area, and whether it is counter-clockwise in it.
    struct View {
        std::int8_t axis = 0;
        std::int8_t sign = 0;  // +1 or -1; 0: the triangle is degenerate
    };

    std::vector<Vec3> points;  // steps
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> across;  // the half-edge on the other side of each half-edge
    std::vector<View> views;            // of each triangle

    std::uint32_t origin(std::uint32_t halfEdge) const { return triangles[halfEdge / 3][halfEdge % 3]; }
    std::uint32_t target(std::uint32_t halfEdge) const { return triangles[halfEdge / 3][(halfEdge % 3 + 1) % 3]; }
    std::uint32_t apex(std::uint32_t halfEdge) const { return triangles[halfEdge / 3][(halfEdge % 3 + 2) % 3]; }
    Vec3 corner(std::uint32_t triangle, int k) const { return points[triangles[triangle][k]]; }
    bool isDegenerate(std::uint32_t triangle) const { return views[triangle].sign == 0; }
    Box3 boxOf(std::uint32_t triangle) const;

    /// Turns triangles over: `turned` has an entry for each.
    void turnOver(std::span<const char> turned);
};

/// The view of a triangle.
LatticeSurface::View viewOf(Vec3 a, Vec3 b, Vec3 c);

}  // namespace rubble
