#pragma once

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>
#include <QStringList>

namespace rubble {

/// Paints lines of text on a panel beside a point, the first of several in bold. The panel stays within the canvas and
/// clear of the rulers; `edge` is the colour of its border.
void paintLabel(QPainter& painter, QPointF beside, const QStringList& lines, const CanvasColours& colours,
                const QColor& edge, const CanvasView& view);

}  // namespace rubble
