#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

namespace rubble {

/// What a mesh cannot be asked to keep: this part of its diagonal, 0.01 mm on a metre. Mesh files hold single
/// precision, and their makers rotate and scale what they write; that costs some 1e-7.
inline constexpr double kRelativeMeshTolerance = 1e-5;

/// The distance, m, below which points of a mesh are one and a face is flat: kRelativeMeshTolerance of the diagonal, or
/// four units in the last place of single precision where the mesh lies so far from the origin that those are more.
double meshTolerance(const TriangleMesh& mesh);

/// A mesh in which neighbouring triangles share their points.
struct WeldedMesh {
    TriangleMesh mesh;
    std::vector<std::uint32_t> sources;  // each triangle's index in the mesh it comes from, ascending
    double tolerance = 0.0;              // m
    std::size_t mergedPoints = 0;        // points moved onto another, not counting those that were equal to it
    double farthestMerge = 0.0;          // m
    std::size_t droppedTriangles = 0;    // without area once their corners were merged
};

/// Makes points nearer than meshTolerance() one, the earlier staying where it is, and drops points without a triangle.
/// Expected linear time.
///
/// Errors: BadInput where there is no triangle, a triangle names a point that is not there, or a point is not finite;
/// Degenerate where no triangle has an area.
Result<WeldedMesh> welded(const TriangleMesh& mesh);

}  // namespace rubble
