#pragma once

#include "editor/canvas/CanvasPainting.h"

namespace rubble {

/// Paints a panel into the lower right corner that explains what is shown: signs of seeds by layer and by how they came to
/// stand where they stand, lines, the scale of the colours, and what is marked.
void paintLegend(QPainter& painter, const CanvasView& view, const CanvasContents& contents,
                 const CanvasColours& colours);

}  // namespace rubble
