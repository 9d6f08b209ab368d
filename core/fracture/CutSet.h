#pragma once

#include "core/base/Index.h"
#include "core/fracture/Pattern.h"

#include <functional>

namespace rubble {

/// A straight cut between two points of its set.
struct CutEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t line = 0;  // of its layer: what a report names
};

/// What one layer cuts.
struct CutLayer {
    std::uint32_t id = 0;
    std::uint32_t edgesEnd = 0;  // behind its last edge; the first follows the layer before
    /// Its edges share all points in which they meet, and are else much farther apart than rounding reaches.
    bool isNoded = false;
    /// Which of its cells a point lies in, by an index that is the same whatever the outline is; null where it names none.
    std::function<std::uint32_t(Vec2)> cellAt;
};

/// All straight cuts of a pattern, layer by layer. They may leave the outline; edges of different layers may meet anyhow.
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

/// Straight cuts that one pattern may make; beyond it memory and patience end.
inline constexpr std::uint32_t kMostCuts = 3 * kMostSeeds;

/// Whether a layer of a pattern that is on cuts.
bool hasCuts(const Pattern& pattern);

/// The cuts of a pattern's layers on a validated() outline. Same pattern, same outline, same bits.
///
/// Errors: BadInput where verifyPattern() finds a fault; Limit above kMostCuts; Cancelled.
Result<CutSet> cutsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

/// How wide the joints between the pieces of a pattern are, m: what its widest mortar asks for; 0 where it has none. Cuts run along
/// the middle of the joints.
double jointWidthOf(const Pattern& pattern);

}  // namespace rubble
