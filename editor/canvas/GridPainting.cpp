#include "editor/canvas/GridPainting.h"

#include <QLocale>

#include <cmath>

namespace rubble {

namespace {

constexpr double kLeastFineStep = 14.0;   // pixels
constexpr double kLeastLabelStep = 64.0;  // pixels

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

class RulerPainter {
public:
    RulerPainter(QPainter& painter, const CanvasView& view, const CanvasColours& colours)
        : m_painter(painter), m_view(view), m_shown(view.shown()), m_step(roundStep(kLeastLabelStep / view.scale)) {
        QFont font = painter.font();
        font.setPixelSize(10);
        painter.setFont(font);
        painter.setPen(colours.label);
    }

    void paintTop() {
        forEachLine(m_shown.min.x, m_shown.max.x, m_step / 5.0, [&](double k) {
            const double x = onPixel(m_view.pixels({k * m_step / 5.0, 0.0}).x());
            const bool isLabelled = std::fmod(k, 5.0) == 0.0;
            m_painter.drawLine(QPointF(x, isLabelled ? 4.0 : kRulerWidth - 5.0), QPointF(x, kRulerWidth - 1.0));
            const QString text = isLabelled ? lengthText(k / 5.0 * m_step, m_step) : QString();
            if (isWhole(x + 3.0, x + 3.0 + widthOf(text), m_view.size.width())) {
                m_painter.drawText(QPointF(x + 3.0, 13.0), text);
            }
        });
    }

    void paintLeft() {
        forEachLine(m_shown.min.y, m_shown.max.y, m_step / 5.0, [&](double k) {
            const double y = onPixel(m_view.pixels({0.0, k * m_step / 5.0}).y());
            const bool isLabelled = std::fmod(k, 5.0) == 0.0;
            m_painter.drawLine(QPointF(isLabelled ? 4.0 : kRulerWidth - 5.0, y), QPointF(kRulerWidth - 1.0, y));
            const QString text = isLabelled ? lengthText(k / 5.0 * m_step, m_step) : QString();
            if (!isWhole(y - 3.0 - widthOf(text), y - 3.0, m_view.size.height())) return;
            m_painter.save();
            m_painter.translate(13.0, y - 3.0);
            m_painter.rotate(-90.0);
            m_painter.drawText(QPointF(0.0, 0.0), text);
            m_painter.restore();
        });
    }

private:
    double widthOf(const QString& text) const { return m_painter.fontMetrics().horizontalAdvance(text); }
    /// A label that is cut off may read as another number.
    static bool isWhole(double from, double to, double end) { return from >= kRulerWidth && to <= end; }

    QPainter& m_painter;
    const CanvasView& m_view;
    Box2 m_shown;
    double m_step;  // m, between labels
};

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

void paintRulers(QPainter& painter, const CanvasView& view, const CanvasColours& colours, QPointF pointer) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    const double width = view.size.width(), height = view.size.height();
    RulerPainter rulers(painter, view, colours);
    painter.setClipRect(QRectF(kRulerWidth, 0.0, width, kRulerWidth));
    painter.fillRect(QRectF(0.0, 0.0, width, kRulerWidth), colours.panel);
    rulers.paintTop();
    painter.setClipRect(QRectF(0.0, kRulerWidth, kRulerWidth, height));
    painter.fillRect(QRectF(0.0, 0.0, kRulerWidth, height), colours.panel);
    rulers.paintLeft();
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
