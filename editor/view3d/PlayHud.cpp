#include "editor/view3d/PlayHud.h"

#include "viewport/scene/play/OverlayColours.h"
#include "viewport/widget/OverlayPlate.h"
#include "viewport/widget/ScaleBarItem.h"

#include <QPainter>
#include <QPainterPath>

namespace rubble {

namespace {

const QColor kRunning(242, 140, 40);
const QColor kWaiting(96, 140, 190);
const QColor kTooHeavy(226, 72, 60);
constexpr int kFrame = 3;  // this and the following: points
constexpr int kHudMargin = 12;
constexpr int kAxes = 92;  // width and height of the axes indicator in the corner
constexpr int kMinHintWidth = 240;
constexpr int kChargeWidth = 220;
constexpr int kRampWidth = 120;
constexpr int kChargeHeight = 12;
constexpr int kBesidePointer = 14;
constexpr int kGrabWidth = 240;

QFont boldOf(QFont font) {
    font.setBold(true);
    return font;
}

}  // namespace

void PlayHud::setContent(const Content& content) {
    if (m_content == content) return;
    m_content = content;
    emit changed();
}

void PlayHud::setVisible(bool isVisible) {
    m_isVisible = isVisible;
    emit changed();
}

QString PlayHud::accessibleText() const {
    if (!m_isVisible) return {};
    QStringList texts = QStringList(m_content.title) + lines();
    if (!m_content.grabText.isEmpty()) texts << m_content.grabText;
    return texts.join(", ");
}

void PlayHud::paint(QPainter& painter, QSize size) const {
    if (!m_isVisible) return;
    const QFont font = painter.font();
    paintTrajectory(painter);
    const QRect texts = textPlate(lines(), font);
    paintTexts(painter, texts);
    if (hasHint(size, font)) paintHint(painter, hintPlate(size, font));
    if (hasLegend()) paintLegend(painter, legendPlate(size, texts, font));
    paintSpring(painter, size);
    paintCharge(painter, size);
    paintFrame(painter, size);
}

void PlayHud::paintFrame(QPainter& painter, QSize size) const {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(
        QPen(m_content.isRunning ? kRunning : kWaiting, kFrame, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(
        QRectF(QPointF(), QSizeF(size)).adjusted(kFrame / 2.0, kFrame / 2.0, -kFrame / 2.0, -kFrame / 2.0));
}

/// Dashes with a dark outline, visible on any background, and a ring at the hit.
void PlayHud::paintTrajectory(QPainter& painter) const {
    if (m_content.trajectory.empty()) return;
    QPainterPath path;
    for (const QLineF& line : m_content.trajectory) {
        if (path.currentPosition() != line.p1()) path.moveTo(line.p1());
        path.lineTo(line.p2());
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(0, 0, 0, 110), 4, Qt::SolidLine, Qt::RoundCap));
    painter.drawPath(path);
    painter.setPen(QPen(kRunning, 2, Qt::DashLine, Qt::FlatCap));
    painter.drawPath(path);
    if (!m_content.hit) return;
    for (const auto& [colour, width] : {std::pair(QColor(0, 0, 0, 110), 4), std::pair(kRunning, 2)}) {
        painter.setPen(QPen(colour, width));
        painter.drawEllipse(*m_content.hit, 7, 7);
    }
}

/// A line from the grabbed point to the pointer, and the text beside the pointer.
void PlayHud::paintSpring(QPainter& painter, QSize size) const {
    if (!m_content.spring) return;
    const QColor colour = m_content.isTooHeavy ? kTooHeavy : kRunning;
    for (const auto& [line, width] : {std::pair(QColor(0, 0, 0, 110), 4), std::pair(colour, 2)}) {
        painter.setPen(QPen(line, width, Qt::SolidLine, Qt::RoundCap));
        painter.setBrush(line);
        painter.drawLine(*m_content.spring);
        painter.drawEllipse(m_content.spring->p1(), 3, 3);
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(m_content.spring->p2(), 7, 7);
    }
    const QRect text = QFontMetrics(painter.font())
                           .boundingRect(QRect(0, 0, kGrabWidth, size.height()), Qt::TextWordWrap, m_content.grabText);
    QRect plate(QPoint(), text.size() + QSize(2 * kPlatePadding, 2 * kPlatePadding));
    const QPoint pointer = m_content.spring->p2().toPoint();
    plate.moveTopLeft(pointer + QPoint(kBesidePointer, kBesidePointer));
    plate.moveRight(std::min(plate.right(), size.width() - kHudMargin));
    if (plate.bottom() > hintPlate(size, painter.font()).top()) plate.moveBottom(pointer.y() - kBesidePointer);
    const QRect inside = paintPlate(painter, plate);
    painter.setPen(kPlateText);
    painter.drawText(inside, Qt::TextWordWrap, m_content.grabText);
}

/// Those below the title.
QStringList PlayHud::lines() const {
    return m_content.collapse.isEmpty() ? m_content.statistics : m_content.statistics + QStringList(m_content.collapse);
}

/// In the upper left corner.
QRect PlayHud::textPlate(const QStringList& lines, const QFont& font) const {
    const QFontMetrics metrics(font), title(boldOf(font));
    int width = title.horizontalAdvance(m_content.title);
    for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
    const int height = title.height() + static_cast<int>(lines.size()) * metrics.height();
    return {kHudMargin, kHudMargin, width + 2 * kPlatePadding, height + 2 * kPlatePadding - 4};
}

/// In the upper right corner, or below the texts where the view is narrow.
QRect PlayHud::legendPlate(QSize size, const QRect& texts, const QFont& font) const {
    const QFontMetrics lines(font);
    const int width = std::max(kRampWidth + kChargeHeight + 6 + lines.horizontalAdvance(tr("breaks")),
                               lines.horizontalAdvance(legendTitle()));
    const int height = 2 * lines.height() + kChargeHeight + 2 * kPlatePadding;
    const QRect plate(size.width() - kHudMargin - width - 2 * kPlatePadding, kHudMargin, width + 2 * kPlatePadding,
                      height);
    return plate.left() > texts.right() + kHudMargin ? plate : plate.translated(0, texts.bottom() + 1);
}

/// Between the axes and the scale bar, or above both where the view is narrow.
QRect PlayHud::hintPlate(QSize size, const QFont& font) const {
    const int between = size.width() - kAxes - ScaleBarItem::maxWidth();
    const bool isNarrow = between < kMinHintWidth;
    const int around = 2 * kPlatePadding, left = isNarrow ? kHudMargin : kAxes;
    const QRect room(0, 0, (isNarrow ? size.width() - 2 * kHudMargin : between) - around, 1000);
    const QSize text = QFontMetrics(font).boundingRect(room, Qt::TextWordWrap, m_content.hint).size();
    const int bottom = size.height() - (isNarrow ? kAxes : kHudMargin), height = text.height() + around - 4;
    return {left, bottom - height, text.width() + around, height};
}

/// Only where it does not cover the texts.
bool PlayHud::hasHint(QSize size, const QFont& font) const {
    return !m_content.hint.isEmpty() && hintPlate(size, font).top() > textPlate(lines(), font).bottom();
}

/// Without the line on what would fall, which comes and goes with the pointer: the view is framed between the plates.
std::vector<QRect> PlayHud::plates(QSize size, const QFont& font) const {
    if (!m_isVisible) return {};
    std::vector<QRect> plates{textPlate(m_content.statistics, font)};
    const bool isHintClear = hintPlate(size, font).top() > plates.front().bottom();
    if (!m_content.hint.isEmpty() && isHintClear) plates.push_back(hintPlate(size, font));
    if (hasLegend()) plates.push_back(legendPlate(size, plates.front(), font));
    return plates;
}

void PlayHud::paintTexts(QPainter& painter, const QRect& plate) const {
    const QFont font = painter.font();
    const QRect text = paintPlate(painter, plate);
    painter.setPen(kPlateText);
    painter.setFont(boldOf(font));
    painter.drawText(text, Qt::AlignTop, m_content.title);
    const int title = painter.fontMetrics().height();
    painter.setFont(font);
    painter.setPen(kPlateSecondaryText);
    painter.drawText(text.adjusted(0, title, 0, 0), Qt::AlignTop, lines().join('\n'));
}

void PlayHud::paintHint(QPainter& painter, const QRect& plate) const {
    const QRect text = paintPlate(painter, plate);
    painter.setPen(kPlateSecondaryText);
    painter.drawText(text, Qt::TextWordWrap, m_content.hint);
}

void PlayHud::paintCharge(QPainter& painter, QSize size) const {
    if (!m_content.charge) return;
    const QFontMetrics lines(painter.font());
    const int height = kChargeHeight + lines.height() + 2 * kPlatePadding;
    const int top = std::min(static_cast<int>(0.72 * size.height()), size.height() - kHudMargin - height);
    const QRect plate((size.width() - kChargeWidth) / 2 - kPlatePadding, top, kChargeWidth + 2 * kPlatePadding, height);
    const QRect inside = paintPlate(painter, plate);
    QRect bar(inside.left(), inside.top() + 2, inside.width(), kChargeHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 50));
    painter.drawRoundedRect(bar, 3, 3);
    bar.setWidth(static_cast<int>(*m_content.charge * bar.width()));
    painter.setBrush(kRunning);
    painter.drawRoundedRect(bar, 3, 3);
    painter.setPen(kPlateText);
    painter.drawText(inside.adjusted(0, kChargeHeight + 2, 0, 0), Qt::AlignHCenter | Qt::AlignBottom,
                     m_content.chargeText);
}

QString PlayHud::legendTitle() const {
    if (!m_content.hasHeat) return tr("Damage of bonds");
    const QString heat = m_content.isForecast ? tr("Forecast: impact ÷ threshold") : tr("Impact ÷ threshold");
    return m_content.hasBonds ? tr("%1, damage of bonds").arg(heat) : heat;
}

/// The legend of the colours of heat and damage.
void PlayHud::paintLegend(QPainter& painter, const QRect& plate) const {
    const QFontMetrics lines(painter.font());
    const int square = kChargeHeight;
    const QRect inside = paintPlate(painter, plate);
    const auto colourOf = [](double value) {
        const Colour colour = heatColour(value);
        return QColor::fromRgbF(static_cast<float>(colour.red), static_cast<float>(colour.green),
                                static_cast<float>(colour.blue));
    };
    painter.setPen(kPlateText);
    painter.drawText(inside, Qt::AlignTop, legendTitle());
    const int top = inside.top() + lines.height() + 2;
    for (int x = 0; x < kRampWidth; ++x) {
        painter.fillRect(QRect(inside.left() + x, top, 1, square), colourOf(0.999 * x / (kRampWidth - 1)));
    }
    const int signal = inside.left() + kRampWidth + 4;
    painter.fillRect(QRect(signal, top, square, square), colourOf(1.0));
    painter.setPen(kPlateSecondaryText);
    painter.drawText(QRect(inside.left(), top + square, kRampWidth, lines.height()), Qt::AlignLeft, "0");
    painter.drawText(QRect(inside.left(), top + square, kRampWidth, lines.height()), Qt::AlignRight, "1");
    painter.drawText(QRect(signal + square + 3, top + (square - lines.height()) / 2, 200, lines.height()),
                     Qt::AlignLeft, tr("breaks"));
}

}  // namespace rubble

#include "moc_PlayHud.cpp"
