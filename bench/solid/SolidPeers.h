#pragma once

#include "core/geometry/mesh/TriangleMesh.h"

#include <cstddef>
#include <span>
#include <vector>

namespace rubble::bench {

/// A plane, with `normal` of length 1: points are on it where dot(normal, point) = offset.
struct CellPlane {
    Vec3 normal{0.0, 0.0, 1.0};
    double offset = 0.0;  // m
};

/// A Voronoi cell in a box around a mesh, as peers get it, who have no Voronoi diagram of their own.
struct ConvexCell {
    std::vector<Vec3> corners;      // m
    std::vector<CellPlane> planes;  // towards neighbours: the cell is on the negative side
};

/// The cells of seeds in a box that is a little larger than a mesh's.
std::vector<ConvexCell> cellsAround(const TriangleMesh& mesh, std::span<const Vec3> seeds);

/// What a mesh is cut into.
struct CutSum {
    std::size_t cells = 0;  // that are not empty
    double volume = 0.0;    // m³, of all
};

/// By CGAL: cell by cell, the corefinement of mesh and cell, with exact predicates and inexact constructions.
CutSum cutByCgal(const TriangleMesh& mesh, std::span<const ConvexCell> cells);

/// Whether Manifold was found when the benchmarks were built.
bool hasManifold();
/// By Manifold with all its threads: cell by cell, the intersection with the hull of the cell's corners. `threads`
/// cells at a time.
CutSum intersectedByManifold(const TriangleMesh& mesh, std::span<const ConvexCell> cells, int threads);
/// By Manifold with all its threads: cell by cell, the part of the mesh on the inner side of all planes.
CutSum splitByManifold(const TriangleMesh& mesh, std::span<const ConvexCell> cells);

}  // namespace rubble::bench
