#pragma once

#include "editor/canvas/painting/CanvasView.h"

namespace rubble {

// Which part of the plane a canvas shows. `legend`: in pixels; empty without one.

/// Fits an asset's box between the rulers, which cover two edges, and beside the legend where that leaves enough room.
CanvasView fittedBeside(const CanvasView& view, const Box2& asset, const QRectF& legend);

/// The same, below what covers `above` pixels under the upper ruler.
CanvasView fittedBelow(CanvasView view, const Box2& asset, const QRectF& legend, double above);

/// Whether the legend covers a part of an asset's box.
bool isCovered(const CanvasView& view, const Box2& asset, const QRectF& legend);

/// Frames a selection with some context around it, but shows no more than the asset. The size of the selection may be
/// zero.
CanvasView framed(const CanvasView& view, const Box2& selection, const Box2& asset);

}  // namespace rubble
