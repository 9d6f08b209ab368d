#pragma once

#include "core/geometry/mesh/TriangleMesh.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rubble::oracle {

/// The part of a seed's cell inside a solid, from exact arithmetic. Only the results are rounded: their relative error
/// is below 1e-12.
struct ExactSolidCell {
    double volume = 0.0;       // m³
    std::uint32_t parts = 0;   // connected through faces
    std::uint32_t shells = 0;  // of their boundaries: one for each part, and one for each cavity
    /// The sum of the Euler numbers of the shells; a shell that touches itself counts as if it was parted there.
    int eulerNumber = 0;
    std::vector<std::pair<std::uint32_t, double>> shared;  // {seed, m² of common face > 0}, ascending
};

/// The Voronoi cells of distinct seeds inside a closed mesh, one for each seed. Shares no code and no formula with
/// core/: cells are clipped from a box by half-spaces, and their common part with the mesh is that of two of CGAL's Nef
/// polyhedra, in rational numbers. For at most a few hundred triangles and thirty seeds.
///
/// No shells of the mesh may touch, and none of its points may join two parts that meet nowhere else: see
/// isNefMesh().
std::vector<ExactSolidCell> exactSolidCells(const TriangleMesh& mesh, std::span<const Vec3> seeds);

/// Whether a mesh is one that a Nef polyhedron can be made of: a surface, everywhere, closed.
bool isNefMesh(const TriangleMesh& mesh);

/// The volume in a closed mesh, computed in rational numbers and rounded once.
double exactVolume(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles);

}  // namespace rubble::oracle
