#pragma once

#include "editor/canvas/painting/CanvasPainting.h"

namespace rubble {

/// Paints the legend into the lower right corner: markers of seeds by origin and layer, lines, the colour scale and
/// highlights.
void paintLegend(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                 const CanvasColours& colours);

}  // namespace rubble
