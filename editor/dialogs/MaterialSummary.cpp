#include "editor/dialogs/MaterialSummary.h"

#include "core/asset/strength/Threshold.h"
#include "core/base/MessageText.h"
#include "core/fracture/pattern/PatternKind.h"
#include "editor/widgets/ColourConversion.h"
#include "editor/widgets/appearance/LayerText.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

namespace rubble {

namespace {

constexpr int kPixelRatio = 3;  // of a swatch, for screens of high resolution

struct MaterialSummaryTexts {
    Q_DECLARE_TR_FUNCTIONS(MaterialSummary)
};

QString htmlText(const std::string& text) { return QString::fromStdString(printableText(text)).toHtmlEscaped(); }

/// Returns a row of the table as HTML, with a note below it unless that is empty.
QString rowOf(const QString& name, const QString& text, const QString& note) {
    const QString row = QString("<tr><td style='padding-right:12px'>%1</td><td>%2</td></tr>").arg(name, text);
    if (note.isEmpty()) return row;
    return row + QString("<tr><td></td><td style='padding-bottom:6px'><small>%1</small></td></tr>").arg(note);
}

QString rowOf(const QString& name, const PresetFigure& figure, const NumberFormat& format, const QLocale& locale) {
    const auto number = [&](double value) { return roundedText(value, format, locale); };
    QString text = "<b>" + withUnit(number(figure.value), format) + "</b>";
    if (figure.range) {
        const auto& [least, most] = *figure.range;
        text += " · " + MaterialSummaryTexts::tr("%1 to %2").arg(number(least), number(most));
    }
    return rowOf(name, text, htmlText(figure.source));
}

QString layerNames(const Pattern& pattern) {
    QStringList kinds;
    for (const PatternLayer& layer : pattern.layers) kinds << layerKindName(layer.parameters).toHtmlEscaped();
    return kinds.isEmpty() ? MaterialSummaryTexts::tr("none") : kinds.join(" + ");
}

}  // namespace

QString materialSummary(const LibraryMaterial& material, const Units& units, const QLocale& locale) {
    const MaterialPreset& preset = material.preset;
    QString summary = QString("<h3>%1</h3>").arg(htmlText(preset.name));
    if (!preset.note.empty()) summary += QString("<p>%1</p>").arg(htmlText(preset.note));
    summary += "<table>" + rowOf(MaterialSummaryTexts::tr("Density"), preset.density, Units::densities(), locale) +
               rowOf(MaterialSummaryTexts::tr("Friction"), preset.friction, {}, locale) +
               rowOf(MaterialSummaryTexts::tr("Restitution"), preset.restitution, {}, locale);
    if (preset.tensileStrength)
        summary += rowOf(MaterialSummaryTexts::tr("Strength"), *preset.tensileStrength, Units::megapascals(), locale);
    if (preset.fractureToughness)
        summary +=
            rowOf(MaterialSummaryTexts::tr("Toughness"), *preset.fractureToughness, Units::toughnesses(), locale);
    if (preset.youngsModulus)
        summary += rowOf(MaterialSummaryTexts::tr("Stiffness"), *preset.youngsModulus, Units::gigapascals(), locale);
    if (const std::optional<double> limit = transitionCrackLength(materialOf(preset, 0))) {
        const QString text = localizedQuantity(QuantityKind::Length, *limit, units, locale);
        summary += rowOf(MaterialSummaryTexts::tr("Crack limit"), "<b>" + text + "</b>",
                         MaterialSummaryTexts::tr("(toughness / strength)² / π: deeper cracks lower the strength"));
    }
    summary += rowOf(MaterialSummaryTexts::tr("Pattern"), layerNames(preset.pattern), {});
    if (preset.roughness.amplitude > 0.0) {
        const QString text = localizedQuantity(QuantityKind::Length, preset.roughness.amplitude, units, locale);
        summary += rowOf(MaterialSummaryTexts::tr("Rough cuts"), text, {});
    }
    if (preset.cutAtImpact) {
        const auto fragments = static_cast<int>(preset.cutAtImpact->fragments);
        summary += rowOf(MaterialSummaryTexts::tr("Breaks"),
                         MaterialSummaryTexts::tr("where it is hit, into %Ln fragment(s)", nullptr, fragments), {});
    }
    const QString file = htmlText(material.file.native());
    if (!file.isEmpty()) summary += rowOf(MaterialSummaryTexts::tr("File"), "<small>" + file + "</small>", {});
    return summary + "</table>";
}

QIcon materialSwatch(const MaterialPreset& preset) {
    QPixmap pixmap(kPixelRatio * kMaterialSwatchSize);
    pixmap.setDevicePixelRatio(kPixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area(0.5, 0.5, kMaterialSwatchSize.width() - 1.0, kMaterialSwatchSize.height() - 1.0);
    QPainterPath frame;
    frame.addRoundedRect(area, 3.0, 3.0);
    painter.setClipPath(frame);
    painter.fillRect(area, toQColor(preset.outside));
    QPainterPath corner;
    corner.addPolygon(
        QPolygonF{{area.right(), area.top()}, {area.right(), area.bottom()}, {area.center().x(), area.bottom()}});
    painter.fillPath(corner, toQColor(preset.inside));
    painter.setClipping(false);
    painter.setPen(QPen(QColor(128, 128, 128), 1.0));
    painter.drawPath(frame);
    painter.end();
    QIcon swatch(pixmap);
    swatch.addPixmap(pixmap, QIcon::Selected);  // otherwise Qt tints it in a selected row
    return swatch;
}

}  // namespace rubble
