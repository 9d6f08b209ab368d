#include "editor/canvas/painting/OutlineFaults.h"

#include "editor/canvas/painting/LabelPainting.h"

#include <cmath>

namespace rubble {

namespace {

constexpr int kMaxFaults = 16;
constexpr double kFaultSize = 6.0;      // pixels, radius of a fault's marker
constexpr double kMaxCoordinate = 1e6;  // pixels; nothing is painted beyond

bool isEdgeFault(const PolygonFault& fault) {
    return fault.kind == PolygonFaultKind::Crossing || fault.kind == PolygonFaultKind::Touching ||
           fault.kind == PolygonFaultKind::TooNear;
}

bool hasPlace(const PolygonFault& fault) {
    return fault.kind != PolygonFaultKind::NotFinite && fault.kind != PolygonFaultKind::TooFewPoints;
}

void paintEdge(QPainter& painter, const Polygon& outline, RingPoint edge, const CanvasView& view) {
    const Ring& ring = ringOf(outline, edge.ring);
    const auto point = static_cast<std::size_t>(edge.point);
    if (point >= ring.size()) return;
    painter.drawLine(view.pixels(ring[point]), view.pixels(ring[(point + 1) % ring.size()]));
}

}  // namespace

std::vector<PolygonFault> outlineFaults(const Polygon& outline) {
    std::vector<PolygonFault> faults = polygonFaults(outline, kMaxFaults);
    if (!faults.empty()) return faults;
    if (std::optional<PolygonFault> narrow = narrowFault(outline)) faults.push_back(std::move(*narrow));
    return faults;
}

void paintFaults(QPainter& painter, const Polygon& outline, const std::vector<PolygonFault>& faults,
                 const CanvasView& view, const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.fault, 3.0, Qt::SolidLine, Qt::RoundCap));
    for (const PolygonFault& fault : faults) {
        if (!isEdgeFault(fault)) continue;
        paintEdge(painter, outline, fault.first, view);
        paintEdge(painter, outline, fault.second, view);
    }
    for (const PolygonFault& fault : faults) {
        const QPointF at = view.pixels(fault.where);
        if (!hasPlace(fault) || std::abs(at.x()) > kMaxCoordinate || std::abs(at.y()) > kMaxCoordinate) continue;
        painter.setPen(QPen(colours.fault, 2.0));
        painter.setBrush(colours.halo);
        painter.drawEllipse(at, kFaultSize, kFaultSize);
        painter.drawLine(at - QPointF(2.5, 2.5), at + QPointF(2.5, 2.5));
        painter.drawLine(at - QPointF(2.5, -2.5), at + QPointF(2.5, -2.5));
    }
    if (faults.empty()) return;
    const QPointF middle(view.size.width() / 2.0, view.size.height() / 2.0);
    const QPointF beside = hasPlace(faults[0]) ? view.pixels(faults[0].where) : middle;
    paintLabel(painter, beside, {QString::fromStdString(faults[0].message)}, colours, colours.fault, view);
}

const Ring& ringOf(const Polygon& outline, int ring) {
    return ring == 0 ? outline.outer : outline.holes[static_cast<std::size_t>(ring - 1)];
}

Ring& ringOf(Polygon& outline, int ring) {
    return ring == 0 ? outline.outer : outline.holes[static_cast<std::size_t>(ring - 1)];
}

int ringCount(const Polygon& outline) { return static_cast<int>(outline.holes.size()) + 1; }

}  // namespace rubble
