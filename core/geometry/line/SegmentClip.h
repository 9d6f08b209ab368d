#pragma once

#include "core/geometry/line/Box2.h"

#include <array>
#include <optional>

namespace rubble {

/// The part of a segment within a box; none if it misses the box. For drawing: not exact.
/// Source: Liang, Barsky 1984, "A new concept and method for line clipping".
std::optional<std::array<Vec2, 2>> clippedTo(const Box2& box, Vec2 from, Vec2 to);

}  // namespace rubble
