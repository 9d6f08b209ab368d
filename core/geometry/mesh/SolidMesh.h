#pragma once

#include "core/base/Result.h"
#include "core/geometry/mesh/TriangleMesh.h"

namespace rubble {

/// A closed mesh whose triangles are all counter-clockwise from outside.
struct SolidMesh {
    TriangleMesh mesh;                   // triangles in input order
    std::vector<std::uint32_t> flipped;  // triangles whose winding was reversed, ascending
    double volume = 0.0;                 // m³
};

/// Orients the triangles of a welded mesh outward. O(n log n).
///
/// Errors, with counts: Degenerate if edges have one triangle or more than two, or if the mesh has several parts, is
/// not orientable or encloses less volume than the tolerance times its area.
Result<SolidMesh> orientedSolid(TriangleMesh mesh, double tolerance);

/// The volume of a closed mesh, m³; negative if its triangles are clockwise from outside.
double signedVolume(const TriangleMesh& mesh);

/// The connected component of each triangle, numbered by their first triangles. Triangles are connected by shared
/// points.
std::vector<std::uint32_t> connectedParts(const TriangleMesh& mesh);

/// As connectedParts(), but solids that only touch, at faces, edges or points, are parts of their own. At an edge with
/// more than two faces, those are connected that have solid between them, as their windings say. A component that would
/// not be split into solids stays whole. O(n log n).
std::vector<std::uint32_t> solidParts(const TriangleMesh& mesh);

}  // namespace rubble
