#include "editor/canvas/painting/GridPainting.h"

#include "editor/widgets/numbers/RoundStep.h"

#include <cmath>

namespace rubble {

namespace {

constexpr double kMinMinorStep = 14.0;  // pixels

/// The number of minor steps between two major lines.
double majorEvery(double step, const Units& units) {
    const double unit = units.roundLength();
    return std::round(unit * roundStep(4.0 * step / unit) / step);
}

}  // namespace

double onPixel(double coordinate) { return std::floor(coordinate + 1e-3) + 0.5; }

double gridStep(const CanvasView& view, const Units& units) {
    const double unit = units.roundLength();
    return unit * roundStep(kMinMinorStep / view.scale / unit);
}

void paintGrid(QPainter& painter, const QRectF& part, const CanvasView& view, const Units& units,
               const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double step = gridStep(view, units), every = majorEvery(step, units);
    const Vec2 low = view.metres(part.bottomLeft() + QPointF(-1.0, 1.0));
    const Vec2 high = view.metres(part.topRight() + QPointF(1.0, -1.0));
    for (const bool isMajor : {false, true}) {
        const auto pen = [&](double k) {
            return k == 0.0 ? colours.axis : std::fmod(k, every) == 0.0 ? colours.grid : colours.minorGrid;
        };
        const auto isPainted = [&](double k) { return isMajor == (std::fmod(k, every) == 0.0); };
        forEachGridLine(low.x, high.x, step, [&](double k) {
            if (!isPainted(k)) return;
            const double x = onPixel(view.pixels({k * step, 0.0}).x());
            painter.setPen(pen(k));
            painter.drawLine(QPointF(x, part.top()), QPointF(x, part.bottom()));
        });
        forEachGridLine(low.y, high.y, step, [&](double k) {
            if (!isPainted(k)) return;
            const double y = onPixel(view.pixels({0.0, k * step}).y());
            painter.setPen(pen(k));
            painter.drawLine(QPointF(part.left(), y), QPointF(part.right(), y));
        });
    }
}

}  // namespace rubble
