#pragma once

#include <QColor>

#include <QPainter>

namespace rubble {

/// Paints the ring that shows a brush at the pointer, dashed for one that erases. The radius is in pixels.
void paintBrushRing(QPainter& painter, QPointF centre, double radius, const QColor& colour, const QColor& halo,
                    bool isErasing);

}  // namespace rubble
