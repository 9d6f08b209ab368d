#include "editor/canvas/widget/CanvasFraming.h"

#include "editor/canvas/painting/RulerPainting.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr double kFitMargin = 24.0;          // pixels around the fitted outline
constexpr double kMinFitBesideLegend = 0.5;  // of the scale of the whole canvas
constexpr double kSelectionMargin = 0.75;    // around the selection, of its size
constexpr double kMinFramedSize = 0.02;      // the smallest framed size, of the outline's
constexpr double kMaxMargin = 0.15;          // around the framed selection, relative to the asset

}  // namespace

CanvasView fittedBeside(const CanvasView& view, const Box2& asset, const QRectF& legend) {
    const QRectF area = QRectF(QPointF(), view.size).adjusted(kRulerWidth, kRulerWidth, 0.0, 0.0);
    const auto fitInto = [&](const QRectF& part) { return fitted(view, part, asset, kFitMargin); };
    const CanvasView whole = fitInto(area);
    if (!isCovered(whole, asset, legend)) return whole;
    QRectF above = area, left = area;
    above.setBottom(legend.top());
    left.setRight(legend.left());
    const CanvasView low = fitInto(above), narrow = fitInto(left);
    const CanvasView& beside = narrow.scale > low.scale ? narrow : low;
    return beside.scale >= kMinFitBesideLegend * whole.scale ? beside : whole;
}

CanvasView fittedBelow(CanvasView view, const Box2& asset, const QRectF& legend, double above) {
    view.size.setHeight(view.size.height() - above);
    view = fittedBeside(view, asset, legend.isEmpty() ? legend : legend.translated(0.0, -above));
    view.size.setHeight(view.size.height() + above);
    view.centre.y += 0.5 * above / view.scale;
    return view;
}

bool isCovered(const CanvasView& view, const Box2& asset, const QRectF& legend) {
    return QRectF(view.pixels(asset.min), view.pixels(asset.max)).normalized().intersects(legend);
}

CanvasView framed(const CanvasView& view, const Box2& selection, const Box2& asset) {
    const double whole = asset.diagonal();
    const Vec2 around(std::clamp(kSelectionMargin * selection.diagonal(), kMinFramedSize * whole, kMaxMargin * whole));
    return fitted(view, QRectF(QPointF(), view.size), {selection.min - around, selection.max + around}, kFitMargin);
}

}  // namespace rubble
