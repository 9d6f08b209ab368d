#include "editor/canvas/tools/OutlineDraft.h"

#include "editor/canvas/painting/OutlineFaults.h"

#include <cmath>

namespace rubble {

namespace {

constexpr double kPoint = 3.5;  // pixels, half the side of a point

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
    if (m_points.size() < 3) return false;
    return std::hypot(m_pen.x - m_points[0].x, m_pen.y - m_points[0].y) <= radius;
}

Polygon OutlineDraft::closed() const { return with(m_points); }

Polygon OutlineDraft::with(const Ring& ring) const {
    if (!m_container) return {ring, {}};
    Polygon outline = *m_container;
    outline.holes.push_back(ring);
    return outline;
}

/// The faults of the edges drawn so far, without the closing edge.
std::vector<PolygonFault> OutlineDraft::openFaults(const Polygon& outline) const {
    const int ring = ringCount(outline) - 1;
    const RingPoint closing{ring, static_cast<int>(ringOf(outline, ring).size()) - 1};
    std::vector<PolygonFault> faults = polygonFaults(outline);
    std::erase_if(faults, [&](const PolygonFault& fault) {
        const bool isOfEdges = fault.kind == PolygonFaultKind::Crossing || fault.kind == PolygonFaultKind::Touching;
        return !isOfEdges || fault.first == closing || fault.second == closing;
    });
    return faults;
}

void OutlineDraft::paint(QPainter& painter, const CanvasView& view, const CanvasColours& colours) const {
    painter.setRenderHint(QPainter::Antialiasing);
    Ring ring = m_points;
    if (ring.empty() || ring.back() != m_pen) ring.push_back(m_pen);
    QPolygonF path;
    for (const Vec2 point : ring) path.push_back(view.pixels(point));

    QColor fill = colours.accent;
    fill.setAlpha(36);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.drawPolygon(path);
    painter.setPen(QPen(colours.accent, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(path);
    painter.setPen(QPen(colours.accent, 1.0, Qt::DashLine));
    painter.drawLine(path.back(), path.front());
    painter.setPen(QPen(colours.accent, 1.5));
    painter.setBrush(colours.halo);
    for (const Vec2 point : m_points) paintPoint(painter, view.pixels(point));

    if (ring.size() < 4) return;
    const Polygon outline = with(ring);
    paintFaults(painter, outline, openFaults(outline), view, colours);
}

}  // namespace rubble
