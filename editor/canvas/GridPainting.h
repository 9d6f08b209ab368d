#pragma once

#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"

#include <QFontMetrics>
#include <QPainter>
#include <QString>

#include <vector>

namespace rubble {

/// How far apart the grid's lines stand at a view, m: 1, 2 or 5 times a power of ten, wide enough to be pointed at.
double gridStep(const CanvasView& view);

/// Paints the grid's lines into a part of the canvas: every line, stronger each fifth or tenth, the axes strongest.
void paintGrid(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasColours& colours);

enum class Ruler { Top, Left };

/// A tick of a ruler.
struct RulerTick {
    double at = 0.0;  // pixels along the ruler
    bool isLabelled = false;
    QString label;      // m, in the user's language; none where it would be cut off, as it may read as another number
    double from = 0.0;  // pixels along the ruler, where the label lies
    double to = 0.0;
};
/// The ticks that a ruler has at a view: five to a label, which stand 1, 2 or 5 times a power of ten apart.
std::vector<RulerTick> rulerTicks(Ruler ruler, const CanvasView& view, const QFontMetrics& letters);

/// Paints rulers along the upper and the left edge with lengths in metres, and a mark where the pointer is.
void paintRulers(QPainter& painter, const CanvasView& view, const CanvasColours& colours, QPointF pointer);
inline constexpr double kRulerWidth = 22.0;  // pixels

}  // namespace rubble
