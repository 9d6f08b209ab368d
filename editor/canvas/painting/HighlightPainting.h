#pragma once

#include "editor/canvas/painting/CanvasPainting.h"
#include "editor/document/Selection.h"

#include <span>

namespace rubble {

// Highlights over the contents of a canvas: the selection and the hovered piece.

void paintOutline(QPainter& painter, const Polygon& outline, const CanvasView& view, const CanvasColours& colours);

/// Highlights the selected seeds and those of their pieces that are selected.
void paintSelection(QPainter& painter, const Selection& selection, const CanvasView& view,
                    const CanvasContents& contents, const CanvasColours& colours);

/// Highlights a piece and its neighbours.
void paintHovered(QPainter& painter, const DrawablePattern& pattern, std::uint32_t piece, const CanvasView& view,
                  const CanvasColours& colours);
/// Paints a label with the fragment's name and properties in a corner, clear of the pointer (pixels), of `panels` and,
/// if there is room, of the fragment and the outline.
void paintFragmentLabel(QPainter& painter, const CanvasContents& contents, std::uint32_t piece, QPointF pointer,
                        std::span<const QRectF> panels, const CanvasView& view, const CanvasColours& colours);

/// Paints the Delaunay triangle at a point (m) and its circumcircle, which contains no other seed; no circle if the
/// pattern has a grain, which makes it an ellipse.
void paintTriangleAt(QPainter& painter, Vec2 point, const CanvasView& view, const CanvasContents& contents,
                     const CanvasColours& colours);

/// Paints a message at the centre of the canvas; `edge` is the colour of its border.
void paintMessage(QPainter& painter, const QString& message, const CanvasView& view, const CanvasColours& colours,
                  const QColor& edge);

/// Paints a hint at the top of the canvas, below `top` (pixels), or at its bottom if the pointer is in its way.
void paintPrompt(QPainter& painter, const QString& text, double top, QPointF pointer, const CanvasView& view,
                 const CanvasColours& colours);

}  // namespace rubble
