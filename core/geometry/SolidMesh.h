#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

namespace rubble {

/// A closed mesh whose triangles all run counter-clockwise from outside.
struct SolidMesh {
    TriangleMesh mesh;                  // triangles in the order they were given
    std::vector<std::uint32_t> turned;  // those that had to be turned round, ascending
    double volume = 0.0;                // m^3
};

/// Turns the triangles of a welded mesh outward. O(n log n).
///
/// Errors, each with counts: Degenerate where edges have one triangle only, or more than two, where the mesh is of
/// several parts, cannot be turned outward (a Möbius strip) or encloses less than the tolerance times its area.
Result<SolidMesh> solidOf(TriangleMesh mesh, double tolerance);

/// The volume inside a closed mesh, m^3; negative where its triangles run clockwise from outside.
double signedVolume(const TriangleMesh& mesh);

/// The part that each triangle belongs to, numbered by their first triangles; parts share no point.
std::vector<std::uint32_t> partsOf(const TriangleMesh& mesh);

}  // namespace rubble
