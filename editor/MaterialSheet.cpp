#include "editor/MaterialSheet.h"

#include "core/asset/PieceColours.h"
#include "core/asset/Threshold.h"
#include "core/fracture/PatternKind.h"
#include "editor/commands/LayerKind.h"
#include "editor/panels/LocalNumber.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

namespace rubble {

namespace {

constexpr int kDigits = 4;
constexpr int kDerivedDigits = 2;  // of what follows from figures that scatter by half of them
constexpr QSize kSwatch{28, 20};   // pixels
constexpr int kSharpness = 3;      // a swatch has so many times as many pixels, for dense screens

QString tr(const char* text) { return QCoreApplication::translate("MaterialSheet", text); }

QString textOf(const std::string& text) { return QString::fromStdString(text).toHtmlEscaped(); }

/// A row of the table, with a note below it where there is one; all in HTML.
QString rowOf(const QString& name, const QString& text, const QString& note) {
    const QString row = QString("<tr><td style='padding-right:12px'>%1</td><td>%2</td></tr>").arg(name, text);
    if (note.isEmpty()) return row;
    return row + QString("<tr><td></td><td style='padding-bottom:6px'><small>%1</small></td></tr>").arg(note);
}

QString rowOf(const QString& name, const PresetFigure& figure, const NumberFormat& format, const QLocale& locale) {
    const auto number = [&](double value) { return roundedText(value, kDigits, format, locale); };
    QString text = "<b>" + withUnit(number(figure.value), format) + "</b>";
    if (figure.range) {
        text += " · " + tr("%1 to %2").arg(number(figure.range->first), number(figure.range->second));
    }
    return rowOf(name, text, textOf(figure.source));
}

QString kindsOf(const Pattern& pattern) {
    QStringList kinds;
    for (const PatternLayer& layer : pattern.layers) kinds << kindText(layer.parameters).toHtmlEscaped();
    return kinds.isEmpty() ? tr("not told") : kinds.join(" + ");
}

}  // namespace

QString materialSheet(const LibraryMaterial& material, const QLocale& locale) {
    const MaterialPreset& preset = material.preset;
    QString sheet = QString("<h3>%1</h3>").arg(textOf(preset.name));
    if (!preset.note.empty()) sheet += QString("<p>%1</p>").arg(textOf(preset.note));
    sheet += "<table>" + rowOf(tr("Density"), preset.density, {tr("kg/m³")}, locale) +
             rowOf(tr("Friction"), preset.friction, {}, locale) +
             rowOf(tr("Restitution"), preset.restitution, {}, locale);
    if (preset.tensileStrength) sheet += rowOf(tr("Strength"), *preset.tensileStrength, {tr("MPa"), -6}, locale);
    if (preset.fractureToughness) sheet += rowOf(tr("Toughness"), *preset.fractureToughness, {tr("MPa√m"), -6}, locale);
    if (const std::optional<double> limit = crackLimit(materialOf(preset, 0))) {
        const NumberFormat format{tr("mm"), 3};
        const QString text = withUnit(roundedText(*limit, kDerivedDigits, format, locale), format);
        sheet += rowOf(tr("Crack limit"), "<b>" + text + "</b>",
                       tr("(toughness / strength)² / π: deeper scratches and cracks leave less than the strength"));
    }
    sheet += rowOf(tr("Breaks in"), kindsOf(preset.pattern), {});
    const QString file = QString::fromStdString(material.file.string()).toHtmlEscaped();
    if (!file.isEmpty()) sheet += rowOf(tr("File"), "<small>" + file + "</small>", {});
    return sheet + "</table>";
}

QIcon materialSwatch(const MaterialPreset& preset) {
    QPixmap pixmap(kSharpness * kSwatch);
    pixmap.setDevicePixelRatio(kSharpness);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF whole(0.5, 0.5, kSwatch.width() - 1.0, kSwatch.height() - 1.0);
    QPainterPath frame;
    frame.addRoundedRect(whole, 3.0, 3.0);
    painter.setClipPath(frame);
    painter.fillRect(whole, QColor(packed(preset.outside)));
    QPainterPath corner;
    corner.addPolygon(
        QPolygonF{{whole.right(), whole.top()}, {whole.right(), whole.bottom()}, {whole.center().x(), whole.bottom()}});
    painter.fillPath(corner, QColor(packed(preset.inside)));
    painter.setClipping(false);
    painter.setPen(QPen(QColor(128, 128, 128), 1.0));
    painter.drawPath(frame);
    painter.end();
    QIcon swatch(pixmap);
    swatch.addPixmap(pixmap, QIcon::Selected);  // else it is tinted where it is chosen
    return swatch;
}

}  // namespace rubble
