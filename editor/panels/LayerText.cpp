#include "editor/panels/LayerText.h"

#include "editor/panels/LocalNumber.h"

#include <QCoreApplication>

#include <array>

namespace rubble {

namespace {

constexpr int kDigits = 4;

// In the order of LayerParameters.
constexpr std::array kIcons{"layer-uniform",  "layer-blue-noise", "layer-placed", "layer-lloyd",         "layer-grid",
                            "layer-clusters", "layer-radial",     "layer-impact", "layer-density-image", "layer-bricks",
                            "layer-slices",   "layer-strokes",    "layer-grain",  "layer-weighted-lloyd"};
static_assert(kIcons.size() == std::variant_size_v<LayerParameters>);

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

    QString operator()(const UniformScatter& scatter) const { return countText(scatter.count); }
    QString operator()(const BlueNoise& noise) const { return tr("%1 apart").arg(length(noise.minimumDistance)); }
    QString operator()(const PlacedSeeds& placed) const {
        return locale.toString(static_cast<qulonglong>(placed.seeds.size()));
    }
    QString operator()(const LloydRelaxation& relaxation) const {
        return counted(relaxation.rounds, tr("1 round"), tr("%1 rounds"), locale);
    }
    QString operator()(const JitteredGrid& grid) const {
        if (grid.cells == GridCells::Size) return tr("%1 × %2").arg(length(grid.cellWidth), length(grid.cellHeight));
        return tr("%1 × %2").arg(locale.toString(grid.columns), locale.toString(grid.rows));
    }
    QString operator()(const Clusters& layer) const {
        return tr("%1 of %2").arg(locale.toString(layer.clusters), seedsText(layer.seedsPerCluster, locale));
    }
    QString operator()(const RadialPattern& radial) const {
        const QString rings = counted(radial.rings, tr("1 ring"), tr("%1 rings"), locale);
        return tr("%1 of %2").arg(rings, locale.toString(radial.spokes));
    }
    QString operator()(const ImpactScatter& scatter) const { return countText(scatter.count); }
    QString operator()(const DensityImage& layer) const {
        return layer.image ? countText(layer.count) : tr("no picture yet");
    }

    QString operator()(const BrickBond& layer) const {
        const double side = layer.bond == BondKind::Header ? layer.width : layer.length;
        return tr("%1 × %2").arg(length(side), length(layer.height));
    }
    QString operator()(const Slices& slices) const { return counted(slices.cuts, tr("1 cut"), tr("%1 cuts"), locale); }
    QString operator()(const Strokes& layer) const {
        return counted(layer.strokes.size(), tr("1 stroke"), tr("%1 strokes"), locale);
    }
    QString operator()(const Grain& grain) const {
        return tr("1 : %1").arg(roundedText(grain.ratio, kDigits, {}, locale));
    }
    QString operator()(const WeightedLloyd& relaxation) const {
        return counted(relaxation.rounds, tr("1 round"), tr("%1 rounds"), locale);
    }

    QString length(double value) const {
        const NumberFormat format = units.lengths();
        return withUnit(roundedText(value, kDigits, format, locale), format);
    }
    QString countText(const SeedCount& count) const {
        switch (count.by) {
            case CountBy::Number: break;
            case CountBy::Density: return tr("%1 per m²").arg(roundedText(count.amount, kDigits, {}, locale));
            case CountBy::PieceSize: return tr("pieces of %1").arg(length(count.amount));
        }
        return seedsText(static_cast<std::size_t>(count.amount), locale);
    }
};

}  // namespace

const char* kindIconName(const LayerParameters& parameters) { return kIcons[parameters.index()]; }

QString layerText(const PatternLayer& layer, const Units& units, const QLocale& locale) {
    return tr("%1, %2").arg(kindText(layer.parameters), std::visit(Describing{units, locale}, layer.parameters));
}

}  // namespace rubble
