#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/solid/ConcaveSplits.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <functional>
#include <vector>

namespace rubble {

/// How closely hulls are to follow solids.
struct HullLimits {
    SplitLimits splits;  // of each solid: more are not made
    // Splits that save least are not made as long as the hulls of all solids exceed these by no more than this in sum,
    // so that hulls are spent where they save most ...
    double sumRatio = 1.03;
    double worstRatio = 1.25;  // ... and those of no solid by more than this
};

/// A fragment as a mesh of its own, in the coordinates of the partition.
TriangleMesh meshOf(const SolidPartition& partition, std::uint32_t fragment);

/// The convex hulls that a closed mesh collides as: one, or one for each part of it, see ConcaveSplits. Parts lie on
/// different sides of planes, so hulls of different parts do not overlap, nor do those of different fragments, whose
/// cells are convex. Hulls are simplified, see collisionDetail(), and lie in the true ones.
///
/// Errors: those of cutSolid() and convexHull().
Result<std::vector<Polytope>> hullsOf(const TriangleMesh& mesh, const HullLimits& limits = {});

/// The hulls of each of several meshes, in their coordinates, each with its error if it has none. In parallel;
/// `meshOf(k)` is called on any thread. What is not done when the task is cancelled is empty.
std::vector<Result<std::vector<Polytope>>> hullsOfEach(std::size_t count,
                                                       const std::function<TriangleMesh(std::uint32_t)>& meshOf,
                                                       const HullLimits& limits, const TaskContext& task);

/// The hulls of each fragment, in the coordinates of the partition. In parallel.
///
/// Errors: those of hullsOf(), with the fragment; Cancelled.
Result<std::vector<std::vector<Polytope>>> fragmentHulls(const SolidPartition& partition, const HullLimits& limits = {},
                                                         const TaskContext& task = {});

/// The hulls that a whole solid collides as: those of the fragments of a coarse cut of it into about `cells` cells of
/// similar size; of meshes with more than 30,000 triangles, sampledHulls(), which cut the mesh once.
///
/// Errors: those of cutSolid() and hullsOf().
Result<std::vector<Polytope>> coarseHulls(const TriangleMesh& mesh, int cells, const TaskContext& task = {});

}  // namespace rubble
