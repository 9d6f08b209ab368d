#include "editor/view3d/tools/GizmoPainting.h"

#include "viewport/widget/ViewportWidget.h"

#include <algorithm>
#include <optional>

namespace rubble {

namespace {

const QColor kAxisColours[] = {QColor(0xe5, 0x48, 0x4d), QColor(0x4c, 0xa8, 0x3d), QColor(0x3b, 0x7d, 0xe0)};
const QColor kViewHandle(0xf2, 0xf2, 0xf2);
const QColor kHighlight(0xff, 0xc4, 0x2e);
const QColor kGizmoUnderline(0, 0, 0, 110);          // separates lines from any background
constexpr double kThinLine = 2.5, kThickLine = 3.5;  // points
constexpr double kTip = 13.0, kTipWidth = 5.0;       // points
constexpr QPointF kGizmoLabelOffset{18.0, 22.0};
constexpr double kLabelMargin = 5.0;

QPointF qt(Vec2 point) { return {point.x, point.y}; }

QPolygonF polygonOf(const std::vector<Vec2>& line) {
    QPolygonF polygon;
    for (const Vec2 point : line) polygon.append(qt(point));
    return polygon;
}

QPolygonF tipOf(Vec2 from, Vec2 to) {
    const Vec2 along = glm::normalize(to - from);
    const Vec2 aside = kTipWidth * perpendicular(along), base = to - kTip * along;
    return {qt(to), qt(base + aside), qt(base - aside)};
}

}  // namespace

void paintHandle(QPainter& painter, GizmoHandle handle, const GizmoView& view, bool isHighlighted) {
    const std::vector<Vec2> line = handleLine(handle, view);
    if (line.empty()) return;
    const QColor colour = isHighlighted ? kHighlight : axisOf(handle) ? kAxisColours[*axisOf(handle)] : kViewHandle;
    const QPolygonF shape = polygonOf(line);
    const double width = isHighlighted ? kThickLine : kThinLine;
    const auto pen = [](const QColor& ink, double wide) {
        return QPen(ink, wide, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    };
    QColor inside = colour;
    inside.setAlpha(isPlaneHandle(handle) ? 90 : 60);
    const bool isArea = isPlaneHandle(handle) || handle == GizmoHandle::MoveInView;
    painter.setBrush(isArea ? QBrush(inside) : QBrush(Qt::NoBrush));
    painter.setPen(pen(kGizmoUnderline, width + 2.0));
    painter.drawPolyline(shape);
    painter.setPen(pen(colour, width));
    isArea ? painter.drawPolygon(shape) : painter.drawPolyline(shape);
    if (line.size() != 2) return;
    painter.setBrush(colour);
    painter.setPen(pen(kGizmoUnderline, 1.0));
    painter.drawPolygon(tipOf(line[0], line[1]));
}

void paintEdges(QPainter& painter, const std::vector<std::array<Vec3, 2>>& edges, const ViewportWidget& viewport) {
    for (const double width : {3.5, 1.5}) {
        painter.setPen(QPen(width > 2.0 ? kGizmoUnderline : kHighlight, width, Qt::SolidLine, Qt::RoundCap));
        for (const auto& [from, to] : edges) {
            if (const std::optional<QLineF> line = viewport.lineOf(from, to)) painter.drawLine(*line);
        }
    }
}

void paintPointerLabel(QPainter& painter, QPointF pointer, const QString& text, QSize viewSize) {
    if (text.isEmpty()) return;
    const QFontMetricsF metrics(painter.font());
    QRectF box(pointer + kGizmoLabelOffset,
               QSizeF(metrics.horizontalAdvance(text) + 2.0 * kLabelMargin, metrics.height() + kLabelMargin));
    box.moveRight(std::min(box.right(), viewSize.width() - kLabelMargin));
    box.moveBottom(std::min(box.bottom(), viewSize.height() - kLabelMargin));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 20, 20, 200));
    painter.drawRoundedRect(box, 4.0, 4.0);
    painter.setPen(Qt::white);
    painter.drawText(box, Qt::AlignCenter, text);
}

}  // namespace rubble
