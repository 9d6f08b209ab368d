#include "editor/dialogs/import/OutlinePreview.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kOutlineMargin = 12.0;  // pixels around the outline
constexpr double kPointRadius = 2.0;     // pixels

QPolygonF toPolygon(const Ring& ring) {
    QPolygonF points;
    for (const Vec2 point : ring) points.append({point.x, point.y});
    return points;
}

}  // namespace

OutlinePreview::OutlinePreview(QWidget* parent) : QWidget(parent) {
    setMinimumSize(120, 120);
    setAccessibleName(tr("Outline"));
}

void OutlinePreview::setOutline(const Polygon& outline, std::vector<Vec2> points) {
    m_outline = outline;
    m_points = std::move(points);
    update();
}

void OutlinePreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    if (m_outline.outer.empty()) return;
    const Box2 bounds = boundsOf(m_outline.outer);
    const double scale = std::min((width() - 2.0 * kOutlineMargin) / std::max(bounds.size().x, 1e-300),
                                  (height() - 2.0 * kOutlineMargin) / std::max(bounds.size().y, 1e-300));
    const Vec2 middle = (bounds.min + bounds.max) / 2.0;
    QTransform pixels;
    pixels.translate(width() / 2.0, height() / 2.0);
    pixels.scale(scale, -scale);
    pixels.translate(-middle.x, -middle.y);
    QPainterPath path;
    path.addPolygon(pixels.map(toPolygon(m_outline.outer)));
    path.closeSubpath();
    for (const Ring& hole : m_outline.holes) {
        path.addPolygon(pixels.map(toPolygon(hole)));
        path.closeSubpath();
    }
    painter.setRenderHint(QPainter::Antialiasing);
    QColor fill = palette().color(QPalette::Highlight);
    fill.setAlphaF(0.25F);
    painter.setBrush(fill);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.5));
    painter.drawPath(path);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Text));
    for (const Vec2 point : m_points)
        painter.drawEllipse(pixels.map(QPointF(point.x, point.y)), kPointRadius, kPointRadius);
}

}  // namespace rubble

#include "moc_OutlinePreview.cpp"
