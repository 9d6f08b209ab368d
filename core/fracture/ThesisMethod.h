#pragma once

#include "core/geometry/Polygon.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The reference method exactly as the thesis writes it, faults included; for comparison only.
struct ThesisDiagram {
    std::vector<std::array<std::uint32_t, 3>> triangles;  // seed indices
    std::vector<Ring> cells;  // one a seed, clipped to the bounding box; may be wrong or empty
};

/// Finite super-triangle at a scale of 20, unbounded edges lengthened by 10 away from the origin, corners sorted by
/// angle, cells clipped to the outline's bounding box.
/// Source: the thesis, listings 1 to 5.
ThesisDiagram thesisDiagram(std::span<const Vec2> outline, std::span<const Vec2> seeds);

}  // namespace rubble
