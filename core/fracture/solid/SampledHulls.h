#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/mesh/TriangleMesh.h"

#include <vector>

namespace rubble {

/// Seeds whose Voronoi cells divide a closed mesh into parts that are nearly convex: from `cells`, evenly spread, to
/// four times as many, more where the surface is farther below the hulls of the parts. Found on points sampled on the
/// surface, in O(n) for n triangles. In the frame of the mesh; the same on any threads; incomplete if the task is
/// cancelled. A point of every triangle has to exist and be finite; empty if no triangle has an area.
std::vector<Vec3> sampledSeeds(const TriangleMesh& mesh, int cells, const TaskContext& task = {});

/// One hull for each part of a closed mesh with many triangles, which is cut once, at sampledSeeds(). A hull has at
/// most as many corners as directions are searched for them, so the mesh may stick out by a hundredth of its size.
/// Hulls do not overlap. In the frame of the mesh. In parallel; the result is the same on any threads.
///
/// Errors: those of cutSolid() and convexHull(); Cancelled.
Result<std::vector<Polytope>> sampledHulls(const TriangleMesh& mesh, int cells, const TaskContext& task = {});

}  // namespace rubble
