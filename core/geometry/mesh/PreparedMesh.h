#pragma once

#include "core/base/TaskContext.h"
#include "core/geometry/mesh/MeshTopology.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A mesh whose neighbours at edges are known, with what was done to get there.
struct PreparedMesh {
    TriangleMesh mesh;                   // every point is used; in their order
    std::vector<std::uint32_t> sources;  // each triangle's index in the mesh as given, ascending
    std::vector<Vec3> onLattice;         // the points, in steps
    double step = 0.0;                   // m
    EdgePairs edges;
    std::vector<std::uint32_t> dropped;  // triangles with a corner twice, of the mesh as given
    std::vector<std::uint32_t> welded;   // points that are another one now, of the mesh as given
    double maxWeldDistance = 0.0;        // m
};

/// Finds the neighbours of a mesh's triangles: by the indices of points if it is closed with them, else with equal
/// points as one, else with points at open edges as one that are within meshTolerance(); the first of these that leave
/// no faulty edge, or else the fewest. The mesh has finite points and a triangle.
///
/// Errors: Cancelled.
Result<PreparedMesh> preparedMesh(const TriangleMesh& mesh, const TaskContext& task);

}  // namespace rubble
