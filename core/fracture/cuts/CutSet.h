#pragma once

#include "core/base/Index.h"
#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace rubble {

/// The maximum number of straight cuts of a pattern.
inline constexpr std::uint32_t kMaxCuts = 30'000'000;

/// A straight cut between two points of its set.
struct CutEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t line = 0;  // index in its layer, as reports name it
};

/// The cuts of one layer.
struct CutLayer {
    std::uint32_t id = 0;
    std::uint32_t edgesEnd = 0;  // end of its edges, which follow those of the layer before
    /// Its edges meet only at common end points, and otherwise are much farther apart than rounding errors.
    bool isNoded = false;
    /// The index of the cell that contains a point, independent of the outline; null if the layer names no cells.
    std::function<std::uint32_t(Vec2)> cellAt;
};

/// All straight cuts of a pattern, layer by layer. They may leave the outline; edges of different layers may intersect.
struct CutSet {
    std::vector<Vec2> points;
    std::vector<CutEdge> edges;
    std::vector<CutLayer> layers;

    bool isEmpty() const { return layers.empty(); }
    std::uint32_t addPoint(Vec2 point) {
        points.push_back(point);
        return static_cast<std::uint32_t>(points.size()) - 1;
    }
};

}  // namespace rubble
