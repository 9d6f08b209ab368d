#pragma once

#include "core/base/UninitializedVector.h"
#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <span>

namespace rubble {

/// The indices of the points along a Hilbert curve over their bounding box: points close in the order are close in the
/// plane. Equal points are consecutive, lowest index first. O(n) for evenly spread points, O(n log n) at worst.
UninitializedVector<std::uint32_t> hilbertOrder(std::span<const Vec2> points, int threads = 1);

}  // namespace rubble
