#pragma once

#include "core/geometry/search/Box3.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// An indexed triangle mesh, as in mesh files; without any invariant.
struct TriangleMesh {
    std::vector<Vec3> points;                             // m
    std::vector<std::array<std::uint32_t, 3>> triangles;  // point indices
};

/// Twice the area vector of a triangle, along its normal.
Vec3 doubleArea(const TriangleMesh& mesh, std::size_t triangle);

/// The bounding box of the points.
Box3 boundsOf(const TriangleMesh& mesh);

}  // namespace rubble
