#pragma once

#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasContents.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>

namespace rubble {

/// Paints background, grid, cells, triangles and seeds, clipped to `part` (pixels).
void paintContents(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasContents& contents,
                   const CanvasColours& colours);

/// The outline of a polygon in pixels.
QPainterPath pathOf(const Polygon& polygon, const CanvasView& view);
QPainterPath pathOfPiece(const DrawablePattern& pattern, std::uint32_t piece, const CanvasView& view);

/// The approximate distance between seeds in a view, pixels.
double seedSpacing(const DrawablePattern& pattern, const CanvasView& view);
/// The radius of a seed marker, pixels: smaller where seeds are dense.
double seedRadius(const DrawablePattern& pattern, const CanvasView& view);
/// Paints a seed marker: a disc if scattered, a diamond if moved by hand, a square if placed.
void paintSeedMarker(QPainter& painter, QPointF centre, double radius, SeedOrigin origin);

}  // namespace rubble
