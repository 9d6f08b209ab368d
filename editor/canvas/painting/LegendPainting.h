#pragma once

#include "editor/canvas/painting/CanvasPainting.h"

namespace rubble {

/// Paints the legend into the lower right corner: markers of seeds by origin and layer, lines, the colour scale and
/// highlights.
/// Returns its area in pixels; empty if there is nothing to explain.
QRectF paintLegend(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours);

}  // namespace rubble
