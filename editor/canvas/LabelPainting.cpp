#include "editor/canvas/LabelPainting.h"

#include "editor/canvas/GridPainting.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

constexpr double kPadding = 6.0;   // pixels, between a panel's border and its text
constexpr double kApart = 14.0;    // pixels, between the point and its panel
constexpr double kMargin = 4.0;    // pixels, between a panel and the canvas's border or its rulers
constexpr double kWidest = 320.0;  // pixels of text; longer lines are broken
constexpr int kDigits = 4;         // that count

QString numberText(double value) {
    const int before = value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    QString text = QLocale().toString(value, 'f', std::clamp(kDigits - before, 0, 12));
    const QString point = QLocale().decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith(QLocale().zeroDigit())) text.chop(1);
        if (text.endsWith(point)) text.chop(point.size());
    }
    return text;
}

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
                                 .boundingRect(QRectF(0.0, 0.0, kWidest, 1000.0), Qt::TextWordWrap, lines[k]);
        places.emplace_back(0.0, size.height(), std::ceil(place.width()) + 1.0, place.height());
        size = {std::max(size.width(), places.back().width()), size.height() + place.height()};
    }
    QRectF panel(beside + QPointF(kApart, kApart), size + QSizeF(2.0 * kPadding, 2.0 * kPadding));
    if (panel.right() > bounds.right()) panel.moveRight(std::max(beside.x() - kApart, bounds.left() + panel.width()));
    if (panel.bottom() > bounds.bottom())
        panel.moveBottom(std::max(beside.y() - kApart, bounds.top() + panel.height()));
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

QString lengthText(double metres) {
    const double size = std::abs(metres);
    if (size == 0.0 || size >= 0.1) return numberText(metres) + QStringLiteral(" m");
    if (size >= 0.01) return numberText(metres * 100.0) + QStringLiteral(" cm");
    return numberText(metres * 1000.0) + QStringLiteral(" mm");
}

QString areaText(double squareMetres) {
    if (squareMetres >= 0.1) return numberText(squareMetres) + QStringLiteral(" m²");
    if (squareMetres >= 1e-4) return numberText(squareMetres * 1e4) + QStringLiteral(" cm²");
    return numberText(squareMetres * 1e6) + QStringLiteral(" mm²");
}

QString volumeText(double cubicMetres) {
    if (cubicMetres >= 0.1) return numberText(cubicMetres) + QStringLiteral(" m³");
    if (cubicMetres >= 1e-4) return numberText(cubicMetres * 1e3) + QStringLiteral(" dm³");
    return numberText(cubicMetres * 1e6) + QStringLiteral(" cm³");
}

QString massText(double kilograms) {
    if (kilograms >= 1e4) return numberText(kilograms / 1e3) + QStringLiteral(" t");
    if (kilograms >= 0.1 || kilograms == 0.0) return numberText(kilograms) + QStringLiteral(" kg");
    return numberText(kilograms * 1e3) + QStringLiteral(" g");
}

QString impulseText(double newtonSeconds) {
    return newtonSeconds < 1e4 ? numberText(newtonSeconds) + QStringLiteral(" N·s")
                               : numberText(newtonSeconds / 1e3) + QStringLiteral(" kN·s");
}

}  // namespace rubble
