#pragma once

#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"

#include <QPainter>
#include <QStringList>

namespace rubble {

/// Paints lines of text on a panel beside a point, the first one bold where there are several, moved so that all of it lies
/// on the canvas and off its rulers. `edge`: the panel's border.
void paintLabel(QPainter& painter, QPointF beside, const QStringList& lines, const CanvasColours& colours,
                const QColor& edge, const CanvasView& view);

/// A length, an area and so on as people write it in their language, with three or four digits that count and a unit that
/// suits: "1.25 m", "3.4 mm", "12.5 cm²", "20.3 dm³", "48.8 kg".
QString lengthText(double metres);
QString areaText(double squareMetres);
QString volumeText(double cubicMetres);
QString massText(double kilograms);
QString impulseText(double newtonSeconds);

}  // namespace rubble
