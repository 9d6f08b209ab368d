#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/hull/Polytope.h"

#include <map>
#include <vector>

namespace rubble {

/// A validated() prism as convex hulls, in its own frame translated so that `origin` becomes the origin.
///
/// Errors: those of convexParts().
Result<std::vector<Polytope>> prismHulls(const Prism& prism, Vec2 origin = {0.0, 0.0});

/// The hulls that a closed mesh collides as, see coarseHulls(), in its own frame translated so that `origin` becomes
/// the origin. Those of the meshes asked for last are kept, see MeshHullCache.
///
/// Errors: those of coarseHulls().
Result<std::vector<Polytope>> meshHulls(const ClosedMesh& mesh, Vec3 origin = {0.0, 0.0, 0.0},
                                        const TaskContext& task = {});

/// The hulls of every asset's whole, in its own frame.
using AssetHulls = std::map<Id, std::vector<Polytope>>;

/// Leaves out assets whose shape cannot be fractured.
AssetHulls assetHulls(const Project& project);

}  // namespace rubble
