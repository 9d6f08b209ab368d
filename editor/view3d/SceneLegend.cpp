#include "editor/view3d/SceneLegend.h"

#include "core/asset/project/FragmentColours.h"
#include "editor/widgets/ColourConversion.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "viewport/widget/OverlayPlate.h"

#include <QLocale>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kMargin = 12;  // this and the following: points
constexpr int kScaleWidth = 150;
constexpr int kScaleHeight = 11;
constexpr int kSample = 18;
constexpr int kBetween = 6;
constexpr int kBetweenEnds = 16;
const QColor kBondColour(250, 140, 26);

QString titleOf(SceneColouring colouring) {
    switch (colouring) {
        case SceneColouring::Level: return SceneLegend::tr("Level");
        case SceneColouring::Volume: return SceneLegend::tr("Fragment volume");
        case SceneColouring::Mass: return SceneLegend::tr("Fragment mass");
        case SceneColouring::Aspect: return SceneLegend::tr("Aspect ratio");
        case SceneColouring::Threshold: return SceneLegend::tr("Parent threshold");
        case SceneColouring::BondStrength: return SceneLegend::tr("Impulse per area of bonds");
        case SceneColouring::Material:
        case SceneColouring::Fragment:
        case SceneColouring::Cluster: break;
    }
    return {};
}

/// A value at an end of the scale, in the unit that suits the larger end.
QString valueText(SceneColouring colouring, double value, double largest, const Units& units) {
    const auto text = [&](QuantityKind kind) { return roundedQuantity(value, quantityFormat(kind, largest, units)); };
    switch (colouring) {
        case SceneColouring::Volume: return text(QuantityKind::Volume);
        case SceneColouring::Mass: return text(QuantityKind::Mass);
        case SceneColouring::Aspect: return QLocale().toString(value, 'f', 1);
        case SceneColouring::Threshold: return text(QuantityKind::Impulse);
        case SceneColouring::BondStrength: return roundedQuantity(value, Units::impulsesPerArea());
        default: return QLocale().toString(value, 'f', 0);
    }
}

}  // namespace

void SceneLegend::setContent(const Content& content) {
    if (content == m_content) return;
    m_content = content;
    emit changed();
}

void SceneLegend::setUnits(const Units& units) {
    m_units = units;
    emit changed();
}

QStringList SceneLegend::texts() const {
    QStringList texts;
    if (m_content.range) {
        const auto& [least, most] = *m_content.range;
        texts = {titleOf(m_content.colouring), valueText(m_content.colouring, least, most, m_units)};
        if (most > least) texts.append(valueText(m_content.colouring, most, most, m_units));
    }
    if (m_content.largestBondArea > 0.0)
        texts.append(
            tr("Contact area up to %1").arg(localizedQuantity(QuantityKind::Area, m_content.largestBondArea, m_units)));
    return texts;
}

/// The text below the scale: at its ends, or about all of it.
QStringList SceneLegend::scaleTexts() const {
    if (!m_content.range) return {};
    const QStringList all = texts();
    if (m_content.range->most > m_content.range->least) return {all[1], all[2]};
    return {tr("all: %1").arg(all[1])};
}

QSize SceneLegend::plateSize(const QFontMetrics& lines) const {
    int width = m_content.range ? kScaleWidth : 0, height = 2 * kPlatePadding - 4;
    for (const QString& text : texts()) width = std::max(width, lines.horizontalAdvance(text));
    int ends = -kBetweenEnds;
    for (const QString& text : scaleTexts()) ends += lines.horizontalAdvance(text) + kBetweenEnds;
    width = std::max(width, ends);
    if (m_content.range) height += 2 * lines.height() + kScaleHeight + 2;
    if (m_content.largestBondArea > 0.0) {
        width = std::max(width, kSample + kBetween + lines.horizontalAdvance(texts().back()));
        height += lines.height() + (m_content.range ? kBetween : 0);
    }
    return {width + 2 * kPlatePadding, height};
}

/// In the upper right corner.
std::vector<QRect> SceneLegend::plates(QSize size, const QFont& font) const {
    if (texts().isEmpty()) return {};
    const QSize plate = plateSize(QFontMetrics(font));
    return {{QPoint(size.width() - plate.width() - kMargin, kMargin), plate}};
}

void SceneLegend::paint(QPainter& painter, QSize size) const {
    const std::vector<QRect> all = plates(size, painter.font());
    if (all.empty()) return;
    QRect inside = paintPlate(painter, all.front());
    const QStringList labels = texts();
    const int line = painter.fontMetrics().height();
    painter.setPen(kPlateText);
    if (m_content.range) {
        painter.drawText(inside, Qt::AlignTop | Qt::AlignLeft, labels[0]);
        const QRect bar(inside.left(), inside.top() + line + 1, inside.width(), kScaleHeight);
        const bool isOne = m_content.range->most <= m_content.range->least;
        for (int x = 0; x < bar.width(); ++x) {
            const double fraction = isOne ? 0.5 : static_cast<double>(x) / (bar.width() - 1);
            painter.fillRect(QRect(bar.left() + x, bar.top(), 1, bar.height()), toQColor(rampColour(fraction)));
        }
        const QRect ends(bar.left(), bar.bottom() + 2, bar.width(), line);
        painter.setPen(kPlateSecondaryText);
        const QStringList values = scaleTexts();
        painter.drawText(ends, (isOne ? Qt::AlignHCenter : Qt::AlignLeft) | Qt::AlignTop, values.front());
        if (!isOne) painter.drawText(ends, Qt::AlignRight | Qt::AlignTop, values.back());
        inside.setTop(ends.bottom() + kBetween);
    }
    if (m_content.largestBondArea <= 0.0) return;
    painter.setPen(QPen(kBondColour, 7.0, Qt::SolidLine, Qt::RoundCap));
    const int middle = inside.top() + line / 2;
    painter.drawLine(inside.left() + 4, middle, inside.left() + kSample - 4, middle);
    painter.setPen(kPlateSecondaryText);
    painter.drawText(inside.adjusted(kSample + kBetween, 0, 0, 0), Qt::AlignTop | Qt::AlignLeft, labels.back());
}

}  // namespace rubble

#include "moc_SceneLegend.cpp"
