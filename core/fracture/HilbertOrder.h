#pragma once

#include "core/geometry/Vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The indices of the points along a Hilbert curve over their bounding box: neighbours in the order lie near in the
/// plane. Equal points come together, lowest index first. O(n) for spread points, O(n log n) at worst.
std::vector<std::uint32_t> hilbertOrder(std::span<const Vec2> points);

}  // namespace rubble
