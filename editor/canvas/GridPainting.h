#pragma once

#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"

#include <QPainter>

namespace rubble {

/// How far apart the grid's lines stand at a view, m: 1, 2 or 5 times a power of ten, wide enough to be pointed at.
double gridStep(const CanvasView& view);

/// Paints the grid's lines into a part of the canvas: every line, stronger each fifth or tenth, the axes strongest.
void paintGrid(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasColours& colours);

/// Paints rulers along the upper and the left edge with lengths in metres, and a mark where the pointer is.
void paintRulers(QPainter& painter, const CanvasView& view, const CanvasColours& colours, QPointF pointer);
inline constexpr double kRulerWidth = 22.0;  // pixels

}  // namespace rubble
