#pragma once

#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"
#include "editor/document/StateComparison.h"

#include <QPainter>

namespace rubble {

/// Paints what became of the pieces of an asset over its cells: what was added and what has another shape is hatched, each its own
/// way, what is gone stands as a ghost of dashes, and of what moved the ghost with an arrow to where it is now. Colours and
/// signs say the same, so that either is enough. Of pieces of pieces those are painted whose whole did not change.
void paintChanges(QPainter& painter, const CanvasView& view, const ComparedAsset& compared,
                  const CanvasColours& colours);

/// The sign of one change, for a legend: about a point, some 16 by 10 pixels.
void paintChangeSign(QPainter& painter, QPointF centre, PieceChange change, const CanvasColours& colours);
/// Its name and how many pieces there are of it: "added: 3".
QString changeText(PieceChange change, std::size_t count);

}  // namespace rubble
