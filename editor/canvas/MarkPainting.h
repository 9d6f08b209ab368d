#pragma once

#include "editor/canvas/CanvasPainting.h"
#include "editor/document/Selection.h"

namespace rubble {

// What is marked over the contents of a canvas: what is chosen, and what the pointer is at.

void paintOutline(QPainter& painter, const Polygon& outline, const CanvasView& view, const CanvasColours& colours);

/// The chosen seeds, and their pieces as far as these are chosen.
void paintChosen(QPainter& painter, const Selection& selection, const CanvasView& view, const CanvasContents& contents,
                 const CanvasColours& colours);

/// A piece and its neighbours.
void paintHovered(QPainter& painter, const ShownPattern& pattern, std::uint32_t piece, const CanvasView& view,
                  const CanvasColours& colours);
/// The name and figures of a piece, beside a point in pixels.
void paintPieceLabel(QPainter& painter, const ShownPattern& pattern, std::uint32_t piece, QPointF beside,
                     const CanvasView& view, const CanvasColours& colours);

/// The triangle at a place (m), and the circle through its corners, which holds no other seed: none where a grain makes it an ellipse.
void paintTriangleAt(QPainter& painter, Vec2 place, const CanvasView& view, const CanvasContents& contents,
                     const CanvasColours& colours);

/// A sentence in the middle of the canvas in place of what it would show, `edge`: its border.
void paintSentence(QPainter& painter, const QString& sentence, const CanvasView& view, const CanvasColours& colours,
                   const QColor& edge);

}  // namespace rubble
