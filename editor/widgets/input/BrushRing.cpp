#include "editor/widgets/input/BrushRing.h"

namespace rubble {

void paintBrushRing(QPainter& painter, QPointF centre, double radius, const QColor& colour, const QColor& halo,
                    bool isErasing) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(halo, 3.0));
    painter.drawEllipse(centre, radius, radius);
    painter.setPen(QPen(colour, 1.5, isErasing ? Qt::DashLine : Qt::SolidLine));
    painter.drawEllipse(centre, radius, radius);
}

}  // namespace rubble
