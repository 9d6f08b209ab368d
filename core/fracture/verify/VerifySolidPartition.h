#pragma once

#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <optional>
#include <span>
#include <string>

namespace rubble {

/// Why a partition of a closed mesh is invalid; nothing for a valid one. It checks that
///   - indices are in range, faces have triangles of three different points, and fragments are ordered by seed;
///   - each fragment is closed: each edge of its triangles is there as often in one direction as in the other;
///   - the outside consists of the mesh's triangles, each covered once: areas agree, and corners lie in its plane;
///   - volumes are positive, are those of the triangles, and sum up to that of the mesh (relative 1e-12);
///   - the centroid of each triangle is nearest to the seed of its fragment; of two as near, to that on its inner side;
///     without seeds, as where fragments were merged, this is not checked.
/// O(triangles · seeds).
std::optional<std::string> verifySolidPartition(const SolidPartition& partition, const TriangleMesh& mesh,
                                                std::span<const Vec3> seeds);

}  // namespace rubble
