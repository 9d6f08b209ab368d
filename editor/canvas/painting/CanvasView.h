#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

namespace rubble {

/// The visible part of the plane: y up in metres, y down in pixels.
struct CanvasView {
    QSizeF size{1.0, 1.0};  // of the canvas, pixels
    Vec2 centre{0.0, 0.0};  // m, at the centre of the canvas
    double scale = 200.0;   // pixels a metre

    QPointF pixels(Vec2 metres) const;
    Vec2 metres(QPointF pixels) const;
    /// The visible part of the plane, m.
    Box2 visibleBox() const;
    bool operator==(const CanvasView&) const = default;
};

/// Zooms by a factor about `pixels`. The scale is limited so that neither rounding errors nor an empty canvas appear.
CanvasView zoomed(CanvasView view, double factor, QPointF pixels);
/// Pans by an offset in pixels.
CanvasView panned(CanvasView view, QPointF pixels);
/// Fits a box into an area of the view, with a margin, both in pixels. An empty box changes nothing.
CanvasView fitted(CanvasView view, const QRectF& area, const Box2& box, double margin);

}  // namespace rubble
