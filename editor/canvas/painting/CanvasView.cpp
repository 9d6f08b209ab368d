#include "editor/canvas/painting/CanvasView.h"

#include <algorithm>

namespace rubble {

namespace {

// Pixels per metre: from a canvas of 1000 km to pixels of 0.1 µm.
constexpr double kMinScale = 1e-3;
constexpr double kMaxScale = 1e7;

}  // namespace

QPointF CanvasView::pixels(Vec2 metres) const {
    return {size.width() / 2.0 + (metres.x - centre.x) * scale, size.height() / 2.0 - (metres.y - centre.y) * scale};
}

Vec2 CanvasView::metres(QPointF pixels) const {
    return centre + Vec2(pixels.x() - size.width() / 2.0, size.height() / 2.0 - pixels.y()) / scale;
}

Box2 CanvasView::visibleBox() const {
    const Vec2 half = Vec2(size.width(), size.height()) / (2.0 * scale);
    return {centre - half, centre + half};
}

CanvasView zoomed(CanvasView view, double factor, QPointF pixels) {
    const Vec2 fixed = view.metres(pixels);
    view.scale = std::clamp(view.scale * factor, kMinScale, kMaxScale);
    view.centre += fixed - view.metres(pixels);
    return view;
}

CanvasView panned(CanvasView view, QPointF pixels) {
    view.centre += Vec2(-pixels.x(), pixels.y()) / view.scale;
    return view;
}

CanvasView fitted(CanvasView view, const QRectF& area, const Box2& box, double margin) {
    const Vec2 extent = box.size();
    if (extent.x < 0.0 || extent.y < 0.0) return view;
    const double width = std::max(area.width() - 2.0 * margin, 1.0);
    const double height = std::max(area.height() - 2.0 * margin, 1.0);
    const double scale = std::min(width / std::max(extent.x, 1e-300), height / std::max(extent.y, 1e-300));
    view.scale = std::clamp(scale, kMinScale, kMaxScale);
    view.centre = box.min + extent / 2.0;
    const QPointF offset = area.center() - QRectF(QPointF(), view.size).center();
    return panned(view, offset.toPoint());  // whole pixels, so that round lengths stay on them
}

}  // namespace rubble
