#pragma once

#include "core/fracture/solid/FaceTriangulation.h"

#include <span>
#include <vector>

namespace rubble {

/// Groups simple loops in a plane, with the inside on their left: each outer loop with the holes in it. A hole that no
/// loop is around, which has hardly any area, is a group of its own. O(outer loops · holes · points) at worst.
std::vector<std::vector<PointLoop>> nestedLoops(std::vector<PointLoop> loops, std::span<const Vec3> points,
                                                const PlaneView& view);

}  // namespace rubble
