#include "viewport/widget/ScaleBarItem.h"

#include "viewport/widget/OverlayPlate.h"
#include "viewport/widget/ViewportWidget.h"

#include <QFontMetrics>
#include <QPainterPath>

#include <utility>

namespace rubble {
namespace {

constexpr int kScaleBarMargin = 12;  // this and the following: points
constexpr int kTickHeight = 5;
constexpr int kTextGap = 2;
constexpr double kHaloWidth = 3.0;

}  // namespace

ScaleBarItem::ScaleBarItem(ViewportWidget& viewport) : OverlayItem(&viewport), m_viewport(viewport) {}

int ScaleBarItem::maxWidth() { return static_cast<int>(kMaxScaleBarWidth) + 2 * kScaleBarMargin; }

void ScaleBarItem::setUnit(ScaleUnit unit) {
    m_unit = std::move(unit);
    emit changed();
}

QString ScaleBarItem::accessibleText() const {
    return isShown() ? tr("Scale bar: %1").arg(QString::fromStdString(length().length.text)) : QString();
}

bool ScaleBarItem::isShown() const { return m_viewport.scene().isOutdoors && m_viewport.settings().hasGrid; }

ScaleBarLength ScaleBarItem::length() const {
    return scaleBarLength(m_viewport.shownCamera(), m_viewport.imageSize(), m_viewport.devicePixelRatioF(), m_unit);
}

std::vector<QRect> ScaleBarItem::plates(QSize size, const QFont& font) const {
    if (!isShown()) return {};
    const int width = qRound(length().points), height = QFontMetrics(font).height() + kTextGap + kTickHeight;
    return {{size.width() - width - kScaleBarMargin, size.height() - height - kScaleBarMargin, width, height}};
}

/// With a halo, visible on any ground.
void ScaleBarItem::paint(QPainter& painter, QSize size) const {
    const std::vector<QRect> all = plates(size, painter.font());
    if (all.empty()) return;
    const QRectF plate = all.front();
    const QString text = QString::fromStdString(length().length.text);
    const auto& [ink, halo] = overlayInk(m_viewport.settings().theme);
    QPainterPath letters;
    letters.addText(plate.center().x() - 0.5 * painter.fontMetrics().horizontalAdvance(text),
                    plate.top() + painter.fontMetrics().ascent(), painter.font(), text);
    const double bar = plate.bottom() - 0.5;
    const QPointF corners[] = {{plate.left() + 0.5, bar - kTickHeight},
                               {plate.left() + 0.5, bar},
                               {plate.right() - 0.5, bar},
                               {plate.right() - 0.5, bar - kTickHeight}};
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(halo, 1.0 + kHaloWidth), std::pair(ink, 1.0)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(corners, 4);
        if (colour == halo) painter.drawPath(letters);
    }
    painter.fillPath(letters, ink);
}

}  // namespace rubble

#include "moc_ScaleBarItem.cpp"
