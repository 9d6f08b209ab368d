#pragma once

#include "core/asset/Project.h"
#include "core/base/Result.h"
#include "core/geometry/Polytope.h"

#include <map>
#include <vector>

namespace rubble {

/// A validated() prism as convex hulls, in its own frame moved so that `about` is the middle of its plane.
///
/// Errors: those of convexParts().
Result<std::vector<Polytope>> prismHulls(const Prism& prism, Vec2 about = {0.0, 0.0});

/// The hulls of every asset's whole, in its prism's frame.
using AssetHulls = std::map<Id, std::vector<Polytope>>;

/// Assets whose prism cannot be fractured are left out.
AssetHulls assetHulls(const Project& project);

}  // namespace rubble
