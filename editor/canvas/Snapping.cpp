#include "editor/canvas/CanvasTool.h"
#include "editor/canvas/GridPainting.h"

#include <cmath>

namespace rubble {

namespace {

constexpr double kCatch = 8.0;  // pixels

double lengthOf(Vec2 vector) { return std::sqrt(vector.x * vector.x + vector.y * vector.y); }

/// The nearest of many points to one, within a reach.
class Nearest {
public:
    Nearest(Vec2 to, double reach) : m_to(to), m_point(to), m_distance(reach) {}
    void offer(Vec2 point) {
        const double distance = lengthOf(point - m_to);
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

void offerCorners(const Polygon& outline, Nearest& nearest) {
    for (const Vec2 corner : outline.outer) nearest.offer(corner);
    for (const Ring& hole : outline.holes) {
        for (const Vec2 corner : hole) nearest.offer(corner);
    }
}

}  // namespace

Vec2 snapped(const CanvasState& state, const CanvasPointer& pointer) {
    if (!state.isSnapping || pointer.modifiers.testFlag(Qt::ShiftModifier)) return pointer.metres;
    Nearest nearest(pointer.metres, kCatch / state.view.scale);
    if (const Asset* asset = state.asset()) offerCorners(asset->prism.outline, nearest);
    if (nearest.isFound()) return nearest.point();
    const double step = gridStep(state.view);
    return {std::round(pointer.metres.x / step) * step, std::round(pointer.metres.y / step) * step};
}

}  // namespace rubble
