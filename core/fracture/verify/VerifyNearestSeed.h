#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/geometry/predicates/Vec.h"

#include <optional>
#include <span>
#include <string>

namespace rubble {

/// Returns the first piece that has a corner nearer to another seed than to its own, or nothing. Since cells are
/// convex, this covers all points of a piece. Tolerance: 1e-9 of the pieces' diameter. O(corners · log seeds),
/// expected.
std::optional<std::string> verifyNearestSeed(const Partition& partition, std::span<const Vec2> seeds);

}  // namespace rubble
