#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/base/UninitializedVector.h"
#include "core/fracture/solid/SolidDiagram.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A closed mesh whose corners are on a lattice: every edge has one triangle on each side.
struct LatticeMesh {
    std::vector<Vec3> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
    std::vector<std::array<std::uint32_t, 2>> edges;      // corners, the lower one first; ascending
    /// Of each triangle, the edge from corner k to the next.
    std::vector<std::array<std::uint32_t, 3>> edgesOfTriangle;

    std::array<Vec3, 3> cornersOf(std::uint32_t triangle) const {
        const std::array<std::uint32_t, 3>& corner = triangles[triangle];
        return {corners[corner[0]], corners[corner[1]], corners[corner[2]]};
    }
};

/// Finds the edges of triangles that are closed; not all if the task is cancelled. O(triangles) but for corners of many
/// of them.
void findEdges(LatticeMesh& mesh, const TaskContext& task = {});

/// What is nearer to a bisector than this, in steps of the lattice, may be there because of rounding to it.
inline constexpr double kTieDistance = 4.0;

/// Where a mesh edge passes from one cell to the next, from its lower corner to its higher one.
struct EdgeCrossing {
    std::uint32_t from = 0, to = 0;  // cells
};

/// Where a Voronoi edge passes through a triangle.
struct TriangleCrossing {
    std::uint32_t edge = 0;  // of the diagram
    std::uint32_t triangle = 0;
    bool isLeaving = false;  // the Voronoi edge, along its direction, leaves the solid there
};

/// A closed mesh as divided by the cells of a diagram: convex pieces of its triangles, and the points where they end.
///
/// Points are numbered: first the corners of the mesh, then the edge crossings, then the triangle crossings. Corners
/// [firstCorner[p], firstCorner[p + 1]) are those of piece p, counter-clockwise from outside; `facet[c]` is the
/// facet of the diagram in which the edge from corner c to the next lies, or kNone where that is on a mesh edge.
struct SurfacePieces {
    std::vector<std::uint32_t> firstCrossing;  // of each mesh edge, + 1
    std::vector<EdgeCrossing> edgeCrossings;
    std::vector<TriangleCrossing> triangleCrossings;

    UninitializedVector<std::uint32_t> triangle, cell;  // of each piece; by triangle
    UninitializedVector<std::uint32_t>
        tiedCell;  // of each piece: in whose bisector, within kTieDistance, it lies; or kNone
    UninitializedVector<std::uint32_t> firstCorner;    // pieces + 1
    UninitializedVector<std::uint32_t> points, facet;  // of each corner

    std::uint32_t pieceCount() const { return static_cast<std::uint32_t>(triangle.size()); }
};

/// The corners of the mesh on whose edge or triangle a point of the surface is, or which it is; none of other points.
std::vector<std::uint32_t> supportOf(const LatticeMesh& mesh, const SurfacePieces& pieces, std::uint32_t point);

/// Divides a mesh by the cells of a diagram with at least one site. The signs alone decide, so that pieces fit together
/// without gaps whatever coincides. O(triangles + pieces), expected.
///
/// Errors: Cancelled.
/// Source: Yan, Lévy, Liu, Sun, Wang, Isotropic remeshing with fast and exact computation of restricted Voronoi
/// diagram, 2009.
Result<SurfacePieces> walkSurface(const LatticeMesh& mesh, const SolidDiagram& diagram, const TaskContext& task = {});

}  // namespace rubble
