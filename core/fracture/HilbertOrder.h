#pragma once

#include "core/base/RawVector.h"
#include "core/geometry/Vec.h"

#include <cstdint>
#include <span>

namespace rubble {

/// The indices of the points along a Hilbert curve over their bounding box: neighbours in the order lie near in the
/// plane. Equal points come together, lowest index first. O(n) for spread points, O(n log n) at worst.
RawVector<std::uint32_t> hilbertOrder(std::span<const Vec2> points, int threads = 1);

}  // namespace rubble
