#include "editor/canvas/painting/LabelPainting.h"

#include "editor/canvas/painting/RulerPainting.h"

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kPadding = 6.0;     // pixels, between border and text
constexpr double kOffset = 14.0;     // pixels, between point and panel
constexpr double kMargin = 4.0;      // pixels, between panel and canvas edge or ruler
constexpr double kMaxWidth = 320.0;  // pixels; longer lines are wrapped

}  // namespace

void paintLabel(QPainter& painter, QPointF beside, const QStringList& lines, const CanvasColours& colours,
                const QColor& edge, const CanvasView& view) {
    const QRectF bounds =
        QRectF({}, view.size).adjusted(kRulerWidth + kMargin, kRulerWidth + kMargin, -kMargin, -kMargin);
    painter.save();
    QFont plain = painter.font(), bold = plain;
    bold.setBold(lines.size() > 1);
    std::vector<QRectF> places;
    QSizeF size(0.0, 0.0);
    for (qsizetype k = 0; k < lines.size(); ++k) {
        const QRectF place = QFontMetricsF(k == 0 ? bold : plain)
                                 .boundingRect(QRectF(0.0, 0.0, kMaxWidth, 1000.0), Qt::TextWordWrap, lines[k]);
        places.emplace_back(0.0, size.height(), std::ceil(place.width()) + 1.0, place.height());
        size = {std::max(size.width(), places.back().width()), size.height() + place.height()};
    }
    QRectF panel(beside + QPointF(kOffset, kOffset), size + QSizeF(2.0 * kPadding, 2.0 * kPadding));
    if (panel.right() > bounds.right()) panel.moveRight(std::max(beside.x() - kOffset, bounds.left() + panel.width()));
    if (panel.bottom() > bounds.bottom())
        panel.moveBottom(std::max(beside.y() - kOffset, bounds.top() + panel.height()));
    panel.moveLeft(std::max(panel.left(), bounds.left()));
    panel.moveTop(std::max(panel.top(), bounds.top()));

    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(edge, 1.0));
    painter.setBrush(colours.panel);
    painter.drawRoundedRect(QRectF(panel.toAlignedRect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
    painter.setPen(colours.text);
    for (qsizetype k = 0; k < lines.size(); ++k) {
        painter.setFont(k == 0 ? bold : plain);
        const QRectF place =
            places[static_cast<std::size_t>(k)].translated(panel.topLeft() + QPointF(kPadding, kPadding));
        painter.drawText(place.adjusted(0.0, 0.0, 2.0, 1.0), Qt::TextWordWrap, lines[k]);
    }
    painter.restore();
}

}  // namespace rubble
