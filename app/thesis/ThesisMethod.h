#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The result of the reference method, implemented as published, errors included; for comparison only.
struct ThesisDiagram {
    std::vector<std::array<std::uint32_t, 3>> triangles;  // seed indices
    std::vector<Ring> cells;  // one per seed, clipped to the bounding box; may be wrong or empty
};

/// Finite super-triangle at a scale of 20, unbounded edges extended by 10 away from the origin, corners sorted by
/// angle, cells clipped to the outline's bounding box.
/// Source: "Creating Realistic Real-Time Destruction Using the Vienna Physics Engine" (bachelor thesis), listings 1 to
/// 5.
ThesisDiagram thesisDiagram(std::span<const Vec2> outline, std::span<const Vec2> seeds);

}  // namespace rubble
