#pragma once

#include "core/base/Result.h"
#include "core/geometry/mesh/TriangleMesh.h"

namespace rubble {

/// The tolerance of imported meshes, relative to the diagonal: 0.01 mm per metre. Mesh files have single precision, and
/// exporters rotate and scale, with errors of about 1e-7.
inline constexpr double kRelativeMeshTolerance = 1e-5;

/// Coordinates of meshes are smaller, m; the square and cube are finite.
inline constexpr double kMaxMeshCoordinate = 1e30;

/// The distance, m, below which points of a mesh are welded and faces count as planar: kRelativeMeshTolerance of the
/// diagonal, or 4 ulp of single precision if the mesh is so far from the origin that this is more.
double meshTolerance(const TriangleMesh& mesh);

/// A mesh whose adjacent triangles share points.
struct WeldedMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> sources;  // each triangle's index in the source mesh, ascending
    double tolerance = 0.0;              // m
    std::size_t mergedPoints = 0;        // points welded to a different position
    double maxMergeDistance = 0.0;       // m
    std::size_t droppedTriangles = 0;    // degenerate after welding
};

/// Welds points within meshTolerance(), to the first of them, and drops points without triangles. O(n) expected.
///
/// Errors: BadInput for no triangles, a point index out of range, or a point that is not finite; Degenerate if all
/// triangles are degenerate.
Result<WeldedMesh> welded(const TriangleMesh& mesh);

}  // namespace rubble
