#pragma once

#include "core/base/Groups.h"
#include "core/fracture/solid/SurfaceWalk.h"

#include <cstdint>

namespace rubble {

/// A directed edge between two points.
struct PointStep {
    std::uint32_t from = 0, to = 0;
    bool operator==(const PointStep&) const = default;
};

/// The boundaries of the facets between cells inside a solid. Their points are those of SurfacePieces, and after them
/// the Voronoi corners, by tetrahedron. The edges of a facet are closed loops, counter-clockwise around the solid's
/// part of it, seen from the cell of the higher site.
struct InnerFaces {
    Groups<PointStep> edges;  // by facet of the diagram
};

/// The number of points of pieces; Voronoi corners have this number and their tetrahedron's together.
std::uint32_t surfacePointCount(const LatticeMesh& mesh, const SurfacePieces& pieces);

/// Finds the facets inside a closed mesh from where its surface meets them. O(n) but for Voronoi edges that pass
/// through the surface more than twice.
///
/// Errors: Degenerate if the surface doesn't bound a solid: if a Voronoi edge enters it twice without leaving it;
/// Cancelled.
Result<InnerFaces> innerFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                              const TaskContext& task = {});

}  // namespace rubble
