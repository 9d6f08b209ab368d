#include "editor/canvas/GridPainting.h"

#include <QLocale>

#include <cmath>

namespace rubble {

namespace {

constexpr double kLeastFineStep = 14.0;   // pixels
constexpr double kLeastLabelStep = 64.0;  // pixels
constexpr double kTicksPerLabel = 5.0;
constexpr double kTickEnd = 4.0,
                 kLetters = 13.0;    // pixels across a ruler: where long ticks end, and where letters stand
constexpr double kBesideTick = 3.0;  // pixels between a tick and its label

/// Lines at k * step for all k whose lines lie between two coordinates.
template <class Visit>
void forEachLine(double from, double to, double step, Visit visit) {
    const double first = std::ceil(from / step), last = std::floor(to / step);
    for (double k = first; k <= last; k += 1.0) visit(k);
}

/// Lines are whole pixels wide and stand on them; those between two pixels on the same one however they were computed.
double onPixel(double coordinate) { return std::floor(coordinate + 1e-3) + 0.5; }

/// How many fine steps a strong line stands apart.
double strongEvery(const CanvasView& view) { return std::round(roundStep(4.0 * gridStep(view)) / gridStep(view)); }

QString lengthText(double metres, double step) {
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return QLocale().toString(metres == 0.0 ? 0.0 : metres, 'f', decimals);
}

void paintTop(QPainter& painter, const RulerTick& tick) {
    painter.drawLine(QPointF(tick.at, tick.isLabelled ? kTickEnd : kRulerWidth - 5.0),
                     QPointF(tick.at, kRulerWidth - 1.0));
    painter.drawText(QPointF(tick.from, kLetters), tick.label);
}

/// Its labels run upwards.
void paintLeft(QPainter& painter, const RulerTick& tick) {
    painter.drawLine(QPointF(tick.isLabelled ? kTickEnd : kRulerWidth - 5.0, tick.at),
                     QPointF(kRulerWidth - 1.0, tick.at));
    if (tick.label.isEmpty()) return;
    painter.save();
    painter.translate(kLetters, tick.to);
    painter.rotate(-90.0);
    painter.drawText(QPointF(0.0, 0.0), tick.label);
    painter.restore();
}

}  // namespace

double gridStep(const CanvasView& view) { return roundStep(kLeastFineStep / view.scale); }

void paintGrid(QPainter& painter, const QRectF& part, const CanvasView& view, const CanvasColours& colours) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double step = gridStep(view), every = strongEvery(view);
    const Vec2 low = view.metres(part.bottomLeft() + QPointF(-1.0, 1.0));
    const Vec2 high = view.metres(part.topRight() + QPointF(1.0, -1.0));
    for (const bool isStrong : {false, true}) {
        const auto pen = [&](double k) {
            return k == 0.0 ? colours.axis : std::fmod(k, every) == 0.0 ? colours.grid : colours.fineGrid;
        };
        const auto isPainted = [&](double k) { return isStrong == (std::fmod(k, every) == 0.0); };
        forEachLine(low.x, high.x, step, [&](double k) {
            if (!isPainted(k)) return;
            const double x = onPixel(view.pixels({k * step, 0.0}).x());
            painter.setPen(pen(k));
            painter.drawLine(QPointF(x, part.top()), QPointF(x, part.bottom()));
        });
        forEachLine(low.y, high.y, step, [&](double k) {
            if (!isPainted(k)) return;
            const double y = onPixel(view.pixels({0.0, k * step}).y());
            painter.setPen(pen(k));
            painter.drawLine(QPointF(part.left(), y), QPointF(part.right(), y));
        });
    }
}

std::vector<RulerTick> rulerTicks(Ruler ruler, const CanvasView& view, const QFontMetrics& letters) {
    const bool isTop = ruler == Ruler::Top;
    const double labelStep = roundStep(kLeastLabelStep / view.scale), step = labelStep / kTicksPerLabel;
    const double end = isTop ? view.size.width() : view.size.height();
    const Box2 shown = view.shown();
    std::vector<RulerTick> ticks;
    forEachLine(isTop ? shown.min.x : shown.min.y, isTop ? shown.max.x : shown.max.y, step, [&](double k) {
        const QPointF place = view.pixels(Vec2(k * step));
        RulerTick& tick = ticks.emplace_back();
        tick.at = onPixel(isTop ? place.x() : place.y());
        tick.isLabelled = std::fmod(k, kTicksPerLabel) == 0.0;
        if (!tick.isLabelled) return;
        tick.label = lengthText(k / kTicksPerLabel * labelStep, labelStep);
        const double length = letters.horizontalAdvance(tick.label);
        tick.from = isTop ? tick.at + kBesideTick : tick.at - kBesideTick - length;
        tick.to = tick.from + length;
        if (tick.from < kRulerWidth || tick.to > end) tick.label.clear();
    });
    return ticks;
}

void paintRulers(QPainter& painter, const CanvasView& view, const CanvasColours& colours, QPointF pointer) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double width = view.size.width(), height = view.size.height();
    QFont font = painter.font();
    font.setPixelSize(10);
    painter.setFont(font);
    painter.setPen(colours.label);
    painter.setClipRect(QRectF(kRulerWidth, 0.0, width, kRulerWidth));
    painter.fillRect(QRectF(0.0, 0.0, width, kRulerWidth), colours.panel);
    for (const RulerTick& tick : rulerTicks(Ruler::Top, view, painter.fontMetrics())) paintTop(painter, tick);
    painter.setClipRect(QRectF(0.0, kRulerWidth, kRulerWidth, height));
    painter.fillRect(QRectF(0.0, 0.0, kRulerWidth, height), colours.panel);
    for (const RulerTick& tick : rulerTicks(Ruler::Left, view, painter.fontMetrics())) paintLeft(painter, tick);
    painter.setClipping(false);
    painter.fillRect(QRectF(0.0, 0.0, kRulerWidth, kRulerWidth), colours.panel);
    painter.drawText(QRectF(0.0, 0.0, kRulerWidth, kRulerWidth), Qt::AlignCenter, QStringLiteral("m"));
    painter.setPen(colours.panelEdge);
    painter.drawLine(QPointF(0.0, kRulerWidth - 0.5), QPointF(width, kRulerWidth - 0.5));
    painter.drawLine(QPointF(kRulerWidth - 0.5, 0.0), QPointF(kRulerWidth - 0.5, height));
    painter.setPen(colours.accent);
    painter.drawLine(QPointF(onPixel(pointer.x()), 0.0), QPointF(onPixel(pointer.x()), kRulerWidth - 1.0));
    painter.drawLine(QPointF(0.0, onPixel(pointer.y())), QPointF(kRulerWidth - 1.0, onPixel(pointer.y())));
    painter.restore();
}

}  // namespace rubble
