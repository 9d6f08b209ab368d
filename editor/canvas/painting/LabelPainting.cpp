#include "editor/canvas/painting/LabelPainting.h"

#include "editor/canvas/painting/RulerPainting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace rubble {

namespace {

constexpr double kPadding = 6.0;     // pixels, between border and text
constexpr double kOffset = 14.0;     // pixels, between point and panel
constexpr double kMargin = 4.0;      // pixels, between panel and canvas edge or ruler
constexpr double kMaxWidth = 320.0;  // pixels; longer lines are wrapped

/// A panel with lines of text.
class Label {
public:
    Label(const QPainter& painter, const QStringList& lines)
        : m_lines(lines), m_plain(painter.font()), m_bold(m_plain) {
        m_bold.setBold(lines.size() > 1);
        QSizeF size(0.0, 0.0);
        for (qsizetype k = 0; k < lines.size(); ++k) {
            const QRectF place =
                QFontMetricsF(fontOf(k)).boundingRect(QRectF(0.0, 0.0, kMaxWidth, 1000.0), Qt::TextWordWrap, lines[k]);
            m_places.emplace_back(0.0, size.height(), std::ceil(place.width()) + 1.0, place.height());
            size = {std::max(size.width(), m_places.back().width()), size.height() + place.height()};
        }
        m_size = size + QSizeF(2.0 * kPadding, 2.0 * kPadding);
    }
    QSizeF size() const { return m_size; }

    void paint(QPainter& painter, const QRectF& panel, const CanvasColours& colours, const QColor& edge) const {
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(edge, 1.0));
        painter.setBrush(colours.panel);
        painter.drawRoundedRect(QRectF(panel.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
        painter.setPen(colours.text);
        for (qsizetype k = 0; k < m_lines.size(); ++k) {
            painter.setFont(fontOf(k));
            const QRectF place =
                m_places[static_cast<std::size_t>(k)].translated(panel.topLeft() + QPointF(kPadding, kPadding));
            painter.drawText(place.adjusted(0.0, 0.0, 2.0, 1.0), Qt::TextWordWrap, m_lines[k]);
        }
        painter.restore();
    }

private:
    const QFont& fontOf(qsizetype line) const { return line == 0 ? m_bold : m_plain; }

    const QStringList& m_lines;
    QFont m_plain, m_bold;
    std::vector<QRectF> m_places;
    QSizeF m_size;
};

/// Where labels may lie.
QRectF boundsIn(const CanvasView& view) {
    return QRectF({}, view.size).adjusted(kRulerWidth + kMargin, kRulerWidth + kMargin, -kMargin, -kMargin);
}

}  // namespace

void paintLabel(QPainter& painter, QPointF beside, const QStringList& lines, const CanvasColours& colours,
                const QColor& edge, const CanvasView& view) {
    const QRectF bounds = boundsIn(view);
    const Label label(painter, lines);
    QRectF panel(beside + QPointF(kOffset, kOffset), label.size());
    if (panel.right() > bounds.right()) panel.moveRight(std::max(beside.x() - kOffset, bounds.left() + panel.width()));
    if (panel.bottom() > bounds.bottom())
        panel.moveBottom(std::max(beside.y() - kOffset, bounds.top() + panel.height()));
    panel.moveLeft(std::max(panel.left(), bounds.left()));
    panel.moveTop(std::max(panel.top(), bounds.top()));
    label.paint(painter, panel, colours, edge);
}

void paintCornerLabel(QPainter& painter, const QStringList& lines, std::span<const LabelObstacle> obstacles,
                      const CanvasColours& colours, const QColor& edge, const CanvasView& view) {
    const QRectF bounds = boundsIn(view);
    const Label label(painter, lines);
    const double right = bounds.right() - label.size().width(), bottom = bounds.bottom() - label.size().height();
    const auto covered = [&](QPointF corner) {
        double sum = 0.0;
        for (const LabelObstacle& obstacle : obstacles) {
            const QRectF common = QRectF(corner, label.size()).intersected(obstacle.area);
            sum += obstacle.weight * common.width() * common.height();
        }
        return sum;
    };
    const std::array corners{QPointF(bounds.left(), bottom), bounds.topLeft(), QPointF(right, bounds.top()),
                             QPointF(right, bottom)};
    label.paint(painter, QRectF(*std::ranges::min_element(corners, {}, covered), label.size()), colours, edge);
}

}  // namespace rubble
