#include "editor/canvas/tools/Snapping.h"

#include "editor/canvas/painting/GridPainting.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kSnapDistance = 8.0;  // pixels

/// Finds the nearest point within a radius.
class Nearest {
public:
    Nearest(Vec2 to, double radius) : m_to(to), m_point(to), m_distance(radius) {}
    void offer(Vec2 point) {
        const double distance = std::hypot(point.x - m_to.x, point.y - m_to.y);
        if (distance > m_distance) return;
        m_point = point;
        m_distance = distance;
        m_isFound = true;
    }
    bool isFound() const { return m_isFound; }
    Vec2 point() const { return m_point; }

private:
    Vec2 m_to;
    Vec2 m_point;
    double m_distance;
    bool m_isFound = false;
};

void addRing(const Ring& ring, SnapTargets& targets) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        targets.points.push_back(ring[k]);
        targets.edges.push_back({ring[k], ring[(k + 1) % ring.size()]});
    }
}

}  // namespace

SnapTargets outlineTargets(const CanvasState& state) {
    SnapTargets targets;
    if (const Asset* asset = state.displayedAsset()) {
        addRing(asset->prism().outline.outer, targets);
        for (const Ring& hole : asset->prism().outline.holes) addRing(hole, targets);
    }
    return targets;
}

Vec2 nearestOnEdge(Vec2 point, Vec2 from, Vec2 to) {
    const Vec2 along = to - from;
    const double length = along.x * along.x + along.y * along.y;
    if (length == 0.0) return from;
    const double fraction = ((point.x - from.x) * along.x + (point.y - from.y) * along.y) / length;
    return from + std::clamp(fraction, 0.0, 1.0) * along;
}

Vec2 snapped(const CanvasState& state, const CanvasPointer& pointer, const SnapTargets& targets) {
    if (!state.isSnapping || pointer.modifiers.testFlag(Qt::ShiftModifier)) return pointer.metres;
    const double radius = kSnapDistance / state.view.scale;
    Nearest point(pointer.metres, radius), edge(pointer.metres, radius);
    for (const Vec2 target : targets.points) point.offer(target);
    if (point.isFound()) return point.point();
    for (const auto& [from, to] : targets.edges) edge.offer(nearestOnEdge(pointer.metres, from, to));
    if (edge.isFound()) return edge.point();
    const double step = gridStep(state.view, state.units);
    return {std::round(pointer.metres.x / step) * step, std::round(pointer.metres.y / step) * step};
}

}  // namespace rubble
