#pragma once

#include "editor/canvas/CanvasTool.h"

#include <array>
#include <vector>

namespace rubble {

/// What points are drawn to when they come near.
struct SnapTargets {
    std::vector<Vec2> points;
    std::vector<std::array<Vec2, 2>> edges;
};
/// The corners and edges of the outline that is shown; nothing where there is none.
SnapTargets outlineTargets(const CanvasState& state);

/// The point of an edge that is nearest to one.
Vec2 nearestOnEdge(Vec2 point, Vec2 from, Vec2 to);

/// Where a point comes to lie: on a target point, else on an edge, else on the grid's next crossing. Only where snapping is
/// on; Shift turns it off.
Vec2 snapped(const CanvasState& state, const CanvasPointer& pointer, const SnapTargets& targets);

}  // namespace rubble
