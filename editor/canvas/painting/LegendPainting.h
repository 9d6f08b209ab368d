#pragma once

#include "editor/canvas/painting/CanvasPainting.h"

namespace rubble {

/// Paints the legend into the lower right corner: markers of seeds by origin and layer, lines, the colour scale and
/// highlights. Returns its area.
QRectF paintLegend(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours);
/// The area of the legend, in pixels; empty if there is nothing to explain.
QRectF legendArea(const QFont& font, const CanvasView& view, const CanvasContents& contents,
                  const CanvasColours& colours);

}  // namespace rubble
