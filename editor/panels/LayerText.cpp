#include "editor/panels/LayerText.h"

#include "editor/panels/LocalNumber.h"

#include <QCoreApplication>

namespace rubble {

namespace {

constexpr int kDigits = 4;

QString tr(const char* text) { return QCoreApplication::translate("LayerText", text); }

/// A noun with its number. Spelt out, so that it reads well without a translation of plurals.
QString counted(std::size_t count, const QString& one, const QString& many, const QLocale& locale) {
    return count == 1 ? one : many.arg(locale.toString(static_cast<qulonglong>(count)));
}

QString seedsText(std::size_t count, const QLocale& locale) {
    return counted(count, tr("1 seed"), tr("%1 seeds"), locale);
}

/// What is said of each kind of layer besides its name.
struct Describing {
    const Units& units;
    const QLocale& locale;

    QString operator()(const UniformScatter& scatter) const { return seedsText(scatter.count, locale); }
    QString operator()(const BlueNoise& noise) const {
        const NumberFormat format = units.lengths();
        return tr("%1 apart").arg(withUnit(roundedText(noise.minimumDistance, kDigits, format, locale), format));
    }
    QString operator()(const PlacedSeeds& placed) const {
        return locale.toString(static_cast<qulonglong>(placed.seeds.size()));
    }
    QString operator()(const LloydRelaxation& relaxation) const {
        return counted(relaxation.rounds, tr("1 round"), tr("%1 rounds"), locale);
    }
};

}  // namespace

QString kindIconName(const LayerParameters& parameters) {
    switch (parameters.index()) {
        case 0: return QStringLiteral("layer-uniform");
        case 1: return QStringLiteral("layer-blue-noise");
        case 2: return QStringLiteral("layer-placed");
        default: return QStringLiteral("layer-lloyd");
    }
}

QString layerText(const PatternLayer& layer, const Units& units, const QLocale& locale) {
    return tr("%1, %2").arg(kindText(layer.parameters), std::visit(Describing{units, locale}, layer.parameters));
}

}  // namespace rubble
