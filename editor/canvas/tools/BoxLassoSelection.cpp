#include "editor/canvas/tools/BoxLassoSelection.h"

namespace rubble {

void BoxLassoSelection::dragTo(QPointF pixels) {
    if (m_shape == Shape::Box) m_path.resize(1);
    m_path.push_back(pixels);
}

bool BoxLassoSelection::contains(QPointF pixels) const {
    return m_shape == Shape::Lasso ? m_path.containsPoint(pixels, Qt::OddEvenFill) : box().contains(pixels);
}

void BoxLassoSelection::paint(QPainter& painter, const CanvasColours& colours) const {
    QColor fill = colours.accent;
    fill.setAlpha(40);
    painter.setBrush(fill);
    painter.setPen(QPen(colours.accent, 1.0, Qt::DashLine));
    if (m_shape == Shape::Lasso) {
        painter.drawPolygon(m_path);
    } else {
        painter.drawRect(box());
    }
}

}  // namespace rubble
