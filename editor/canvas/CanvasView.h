#pragma once

#include "core/geometry/Polygon.h"

#include <QPointF>
#include <QSizeF>

namespace rubble {

/// Which part of the plane a canvas shows: y up in metres, y down in pixels.
struct CanvasView {
    QSizeF size{1.0, 1.0};  // of the canvas, pixels
    Vec2 centre{0.0, 0.0};  // m, in the middle of the canvas
    double scale = 200.0;   // pixels a metre

    QPointF pixels(Vec2 metres) const;
    Vec2 metres(QPointF pixels) const;
    /// All that is shown, m.
    Box2 shown() const;
    bool operator==(const CanvasView&) const = default;
};

/// Larger by a factor, or smaller; what is seen at `pixels` stays there. Neither so far in that digits show, nor so far out
/// that all is one point.
CanvasView zoomed(CanvasView view, double factor, QPointF pixels);
/// What is seen follows the hand, which went by these pixels.
CanvasView panned(CanvasView view, QPointF pixels);
/// With a box in the middle and as large as fits, less a margin in pixels. An empty box changes nothing.
CanvasView fitted(CanvasView view, const Box2& box, double margin);

/// 1, 2 or 5 times a power of ten: the smallest such length that is not below `least`, > 0.
double roundStep(double least);

}  // namespace rubble
