#pragma once

#include "core/fracture/delaunay/Delaunay.h"
#include "core/geometry/predicates/Vec.h"

#include <optional>
#include <span>
#include <string>

namespace rubble {

/// Returns the first fault of a triangulation in one sentence, or nothing: twins agree; every triangle is
/// counter-clockwise; every edge is locally Delaunay (exact, ties by lowest index); every seed is a site or a
/// duplicate; the ghosts form one convex hull.
std::optional<std::string> verifyDelaunay(const Delaunay& delaunay, std::span<const Vec2> seeds);

}  // namespace rubble
