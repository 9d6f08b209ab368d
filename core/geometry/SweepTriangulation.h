#pragma once

#include "core/geometry/NumberedCorners.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// Corner numbers, counter-clockwise.
using CornerTriangle = std::array<std::uint32_t, 3>;

/// Cuts a polygon in canonical winding into triangles of positive area in O(n log n), every sign exact. Edges must not
/// cross; corners may lie on one point where each has a sector of the interior to itself. Nothing where the sweep
/// finds that the rings are no such polygon; what it does give is to be checked by linked().
///
/// Source: Hertel, Mehlhorn, "Fast triangulation of the plane with respect to simple polygons", 1983.
std::optional<std::vector<CornerTriangle>> sweptTriangles(const NumberedCorners& corners);

}  // namespace rubble
