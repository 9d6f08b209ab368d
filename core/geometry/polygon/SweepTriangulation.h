#pragma once

#include "core/geometry/polygon/IndexedCorners.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// Corner indices, counter-clockwise.
using CornerTriangle = std::array<std::uint32_t, 3>;

/// Triangulates a polygon in canonical winding in O(n log n), by exact predicates; all triangles have positive area.
/// Edges must not cross; several corners may coincide after splitTouchingCorners(). Returns nothing if the sweep finds
/// the polygon invalid; the triangles must be checked by linkTriangles(). Adds the number of compared edges and
/// examined triangles to `steps`.
///
/// Source: Hertel, Mehlhorn, "Fast triangulation of the plane with respect to simple polygons", 1983.
std::optional<std::vector<CornerTriangle>> sweepTriangulation(const IndexedCorners& corners,
                                                              std::size_t* steps = nullptr);

}  // namespace rubble
