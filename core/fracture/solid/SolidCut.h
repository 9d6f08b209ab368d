#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <span>

namespace rubble {

/// Cuts a closed mesh into the Voronoi cells of seeds. A cell that falls into several parts gives several fragments.
/// What is cut is decided for corners and seeds on a lattice, at most 2⁻⁴⁰ of the diagonal of their box away,
/// where it is exact: signs alone decide, and each point is rounded once. Where a surface is cut, its points are then
/// placed on the mesh as it is given. Parts of no thickness, which only rounding to the lattice leaves, go to the
/// neighbour with the largest common face.
///
/// The mesh has to be closed, with edges of two triangles each, counter-clockwise from outside; it may touch itself,
/// but not cross itself.
///
/// Errors: BadInput for no triangles, no seeds, or a coordinate that is not finite or beyond kMaxMeshCoordinate;
/// Degenerate if the surface crosses itself where a cell's edge passes; Cancelled.
/// Source: Yan, Wang, Lévy, Liu, Efficient computation of clipped Voronoi diagram, 2013.
Result<SolidPartition> cutSolid(const TriangleMesh& mesh, std::span<const Vec3> seeds, const TaskContext& task = {});

}  // namespace rubble
