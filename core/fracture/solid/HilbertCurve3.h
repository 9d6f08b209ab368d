#pragma once

#include "core/base/UninitializedVector.h"
#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <span>

namespace rubble {

/// The indices of the points along a Hilbert curve through their bounding box, for points in space as hilbertOrder() is
/// for those in the plane. Equal points are consecutive, lowest index first. O(n log n).
///
/// Source: Skilling, Programming the Hilbert curve, 2004.
UninitializedVector<std::uint32_t> hilbertOrder(std::span<const Vec3> points);

}  // namespace rubble
