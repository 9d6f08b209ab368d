#pragma once

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>
#include <QStringList>

#include <span>

namespace rubble {

/// Paints lines of text on a panel beside a point, the first of several in bold. The panel stays within the canvas and
/// clear of the rulers; `edge` is the colour of its border.
void paintLabel(QPainter& painter, QPointF beside, const QStringList& lines, const CanvasColours& colours,
                const QColor& edge, const CanvasView& view);

/// An area that a label should keep clear of, in pixels.
struct LabelObstacle {
    QRectF area;
    double weight = 1.0;  // of its covered part
};
/// The same in the corner of the canvas where it covers least of some areas; the lower left one if all are equal.
void paintCornerLabel(QPainter& painter, const QStringList& lines, std::span<const LabelObstacle> obstacles,
                      const CanvasColours& colours, const QColor& edge, const CanvasView& view);

}  // namespace rubble
