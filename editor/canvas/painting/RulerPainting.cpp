#include "editor/canvas/painting/RulerPainting.h"

#include "editor/canvas/painting/GridPainting.h"
#include "editor/widgets/numbers/NumberText.h"
#include "editor/widgets/numbers/RoundStep.h"

#include <QFontInfo>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kMinLabelStep = 64.0;  // pixels
constexpr double kTicksPerLabel = 5.0;
constexpr double kTickEnd = 4.0;      // of long ticks, pixels across a ruler
constexpr double kTextTop = 6.0;      // of capitals, pixels across a ruler
constexpr double kFontSize = 0.77;    // of the window's
constexpr int kMaxFontSize = 16;      // pixels, with room for capitals and ticks
constexpr double kLabelOffset = 3.0;  // pixels between a tick and its label

QString lengthText(double metres, double step, const NumberFormat& format) {
    const int decimals = static_cast<int>(-std::floor(std::log10(step / format.size()) + 1e-9));
    return QLocale().toString(metres == 0.0 ? 0.0 : metres / format.size(), 'f', std::max(0, decimals));
}

double baseline(const QPainter& painter) { return kTextTop + painter.fontMetrics().capHeight(); }

void paintTop(QPainter& painter, const RulerTick& tick) {
    painter.drawLine(QPointF(tick.at, tick.isLabelled ? kTickEnd : kRulerWidth - 5.0),
                     QPointF(tick.at, kRulerWidth - 1.0));
    painter.drawText(QPointF(tick.from, baseline(painter)), tick.label);
}

/// Labels are rotated to run upwards.
void paintLeft(QPainter& painter, const RulerTick& tick) {
    painter.drawLine(QPointF(tick.isLabelled ? kTickEnd : kRulerWidth - 5.0, tick.at),
                     QPointF(kRulerWidth - 1.0, tick.at));
    if (tick.label.isEmpty()) return;
    painter.save();
    painter.translate(baseline(painter), tick.to);
    painter.rotate(-90.0);
    painter.drawText(QPointF(0.0, 0.0), tick.label);
    painter.restore();
}

}  // namespace

std::vector<RulerTick> rulerTicks(Ruler ruler, const CanvasView& view, const Units& units,
                                  const QFontMetrics& metrics) {
    const bool isTop = ruler == Ruler::Top;
    const double unit = units.roundLength();
    const double labelStep = unit * roundStep(kMinLabelStep / view.scale / unit), step = labelStep / kTicksPerLabel;
    const double end = isTop ? view.size.width() : view.size.height();
    const Box2 shown = view.visibleBox();
    std::vector<RulerTick> ticks;
    forEachGridLine(isTop ? shown.min.x : shown.min.y, isTop ? shown.max.x : shown.max.y, step, [&](double k) {
        const QPointF pixels = view.pixels(Vec2(k * step));
        RulerTick& tick = ticks.emplace_back();
        tick.at = onPixel(isTop ? pixels.x() : pixels.y());
        tick.isLabelled = std::fmod(k, kTicksPerLabel) == 0.0;
        if (!tick.isLabelled) return;
        tick.label = lengthText(k / kTicksPerLabel * labelStep, labelStep, units.lengths());
        const double length = metrics.horizontalAdvance(tick.label);
        tick.from = isTop ? tick.at + kLabelOffset : tick.at - kLabelOffset - length;
        tick.to = tick.from + length;
        if (tick.from < kRulerWidth || tick.to > end) tick.label.clear();
    });
    return ticks;
}

QFont rulerFont(const QFont& font) {
    QFont smaller = font;
    smaller.setPixelSize(std::clamp(qRound(kFontSize * QFontInfo(font).pixelSize()), 1, kMaxFontSize));
    return smaller;
}

void paintRulers(QPainter& painter, const CanvasView& view, const Units& units, const CanvasColours& colours,
                 QPointF pointer) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double width = view.size.width(), height = view.size.height();
    painter.setFont(rulerFont(painter.font()));
    painter.setPen(colours.label);
    painter.setClipRect(QRectF(kRulerWidth, 0.0, width, kRulerWidth));
    painter.fillRect(QRectF(0.0, 0.0, width, kRulerWidth), colours.panel);
    for (const RulerTick& tick : rulerTicks(Ruler::Top, view, units, painter.fontMetrics())) paintTop(painter, tick);
    painter.setClipRect(QRectF(0.0, kRulerWidth, kRulerWidth, height));
    painter.fillRect(QRectF(0.0, 0.0, kRulerWidth, height), colours.panel);
    for (const RulerTick& tick : rulerTicks(Ruler::Left, view, units, painter.fontMetrics())) paintLeft(painter, tick);
    painter.setClipping(false);
    painter.fillRect(QRectF(0.0, 0.0, kRulerWidth, kRulerWidth), colours.panel);
    painter.drawText(QRectF(0.0, 0.0, kRulerWidth, kRulerWidth), Qt::AlignCenter, units.lengths().unit);
    painter.setPen(colours.panelEdge);
    painter.drawLine(QPointF(0.0, kRulerWidth - 0.5), QPointF(width, kRulerWidth - 0.5));
    painter.drawLine(QPointF(kRulerWidth - 0.5, 0.0), QPointF(kRulerWidth - 0.5, height));
    painter.setPen(colours.accent);
    painter.drawLine(QPointF(onPixel(pointer.x()), 0.0), QPointF(onPixel(pointer.x()), kRulerWidth - 1.0));
    painter.drawLine(QPointF(0.0, onPixel(pointer.y())), QPointF(kRulerWidth - 1.0, onPixel(pointer.y())));
    painter.restore();
}

}  // namespace rubble
