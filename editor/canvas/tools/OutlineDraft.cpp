#include "editor/canvas/tools/OutlineDraft.h"

#include "core/geometry/polygon/OutlineShapes.h"
#include "editor/canvas/painting/OutlineFaults.h"

#include <cmath>

namespace rubble {

namespace {

constexpr double kPoint = 3.5;      // pixels, half the side of a point
constexpr int kCircleCorners = 32;  // the polygon's edges are within half a percent of the circle's radius

void paintPoint(QPainter& painter, QPointF at) {
    painter.drawRect(QRectF(at.x() - kPoint, at.y() - kPoint, 2.0 * kPoint, 2.0 * kPoint));
}

}  // namespace

void OutlineDraft::add() {
    if (m_points.empty() || m_points.back() != m_pen) m_points.push_back(m_pen);
}

bool OutlineDraft::removeLast() {
    if (m_points.empty()) return false;
    m_points.pop_back();
    return true;
}

bool OutlineDraft::closesAt(double radius) const {
    if (m_shape != DraftShape::Polygon || m_points.size() < 3) return false;
    return std::hypot(m_pen.x - m_points[0].x, m_pen.y - m_points[0].y) <= radius;
}

Ring OutlineDraft::ringOf(const Ring& points) const {
    if (m_shape == DraftShape::Polygon || points.size() < 2) return points;
    const Vec2 from = points[0], to = points[1];
    if (m_shape == DraftShape::Rectangle) return {from, {to.x, from.y}, to, {from.x, to.y}};
    Ring circle = regularPolygonOutline(kCircleCorners, 2.0 * std::hypot(to.x - from.x, to.y - from.y)).outer;
    for (Vec2& corner : circle) corner += from;
    return circle;
}

/// The faults of the edges drawn so far, without the closing edge.
std::vector<PolygonFault> OutlineDraft::openFaults(const Polygon& outline) const {
    const RingPoint closing{0, static_cast<int>(outline.outer.size()) - 1};
    std::vector<PolygonFault> faults = polygonFaults(outline);
    std::erase_if(faults, [&](const PolygonFault& fault) {
        const bool isOfEdges = fault.kind == PolygonFaultKind::Crossing || fault.kind == PolygonFaultKind::Touching;
        return !isOfEdges || fault.first == closing || fault.second == closing;
    });
    return faults;
}

void OutlineDraft::paint(QPainter& painter, const CanvasView& view, const CanvasColours& colours) const {
    painter.setRenderHint(QPainter::Antialiasing);
    Ring points = m_points;
    if (points.empty() || points.back() != m_pen) points.push_back(m_pen);
    const Ring ring = ringOf(points);
    QPolygonF path;
    for (const Vec2 point : ring) path.push_back(view.pixels(point));

    QColor fill = colours.accent;
    fill.setAlpha(36);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(path);
    painter.setPen(QPen(colours.accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(path);
    const bool isOpen = m_shape == DraftShape::Polygon;
    painter.setPen(QPen(colours.accent, isOpen ? 1.0 : 2.0, isOpen ? Qt::DashLine : Qt::SolidLine));
    painter.drawLine(path.back(), path.front());
    painter.setPen(QPen(colours.accent, 1.5));
    painter.setBrush(colours.halo);
    for (const Vec2 point : m_points) paintPoint(painter, view.pixels(point));

    if (!isOpen || ring.size() < 4) return;
    const Polygon outline{ring, {}};
    paintFaults(painter, outline, openFaults(outline), view, colours);
}

}  // namespace rubble
