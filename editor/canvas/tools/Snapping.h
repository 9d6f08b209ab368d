#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include <array>
#include <vector>

namespace rubble {

/// The points and edges to snap to.
struct SnapTargets {
    std::vector<Vec2> points;
    std::vector<std::array<Vec2, 2>> edges;
};
/// The corners and edges of the displayed outline; empty if there is none.
SnapTargets outlineTargets(const CanvasState& state);

/// The point of the edge from `from` to `to` that is nearest to `point`.
Vec2 nearestOnEdge(Vec2 point, Vec2 from, Vec2 to);

/// Snaps the pointer to a target point, otherwise an edge, otherwise the grid. Only if snapping is on; Shift disables
/// it.
Vec2 snapped(const CanvasState& state, const CanvasPointer& pointer, const SnapTargets& targets);

}  // namespace rubble
