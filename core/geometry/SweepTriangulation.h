#pragma once

#include "core/geometry/NumberedCorners.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// Corner numbers, counter-clockwise.
using CornerTriangle = std::array<std::uint32_t, 3>;

/// Cuts a polygon in canonical winding into n + 2h - 2 triangles of positive area in O(n log n), every sign exact.
/// Corners may meet where a planar subdivision's face touches itself. Nothing where the sweep finds that the rings
/// are no such polygon; it may find triangles where edges cross unnoticed.
///
/// Source: Hertel, Mehlhorn, "Fast triangulation of the plane with respect to simple polygons", 1983.
std::optional<std::vector<CornerTriangle>> sweptTriangles(const NumberedCorners& corners);

}  // namespace rubble
