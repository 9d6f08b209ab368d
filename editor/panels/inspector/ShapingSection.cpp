#include "editor/panels/inspector/ShapingSection.h"

#include "core/asset/project/AssetShape.h"
#include "editor/document/Selection.h"
#include "editor/widgets/ProjectRange.h"

namespace rubble {

namespace {

template <class Value>
void addItem(QComboBox& box, Value value, const QString& text) {
    box.addItem(text, static_cast<Id>(value));
}

bool isFraction(const SmallPieces& small) {
    return small.measure == PieceMeasure::FractionOfMean || small.measure == PieceMeasure::FractionOfWhole;
}

/// Changes the measure. A limit in another unit is replaced by a default.
SmallPieces withMeasure(SmallPieces small, PieceMeasure measure, const Asset& asset) {
    const bool wasFraction = isFraction(small);
    small.measure = measure;
    if (isFraction(small) == wasFraction && wasFraction) return small;
    constexpr double kDefaultFractionOfMean = 0.1, kDefaultFractionOfWhole = 0.001;
    const double depth = sizeOf(asset).z;
    const double planeArea = asset.isPrism() ? area(asset.prism().outline) : volumeOf(asset) / depth;
    small.limit = isFraction(small) ? kDefaultFractionOfMean : kDefaultFractionOfWhole * planeArea;
    if (measure == PieceMeasure::Volume) small.limit *= depth;
    return small;
}

}  // namespace

ShapingSection::ShapingSection(Document& document, const Selection& selection, QWidget* parent)
    : Section("fragments", tr("Fragments"), parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [this] { return selected(); }, pushOf<Asset>(document)) {
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([](const Asset& asset) {
        return QString::fromStdString(verifyShaping(asset.shaping).value_or(std::string()));
    });
    buildSmallPieces();
    m_gap = addRow(tr("Gap"), new NumberField,
                   tr("Width of the gap between fragments; each shrinks by half of it along its cuts"));
    m_gap->setRange(fieldRange(ProjectNumber::Gap));
    m_form.bind(
        m_gap, tr("Set Gap"), [](const Asset& asset) { return asset.shaping.gap; },
        [](Asset& asset, double entered) { asset.shaping.gap = entered; });
    buildRoughness();
}

std::vector<Asset> ShapingSection::selected() const {
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

void ShapingSection::buildSmallPieces() {
    auto* rule = addRow(tr("Small fragments"), new QComboBox, tr("What to do with fragments below the minimum size"));
    addItem(*rule, SmallPieceRule::Keep, tr("Keep"));
    addItem(*rule, SmallPieceRule::Merge, tr("Merge"));
    addItem(*rule, SmallPieceRule::DropSeeds, tr("Delete Their Seeds"));
    m_form.bind(
        rule, tr("Set Small Fragments"),
        [](const Asset& asset) { return static_cast<Id>(asset.shaping.smallPieces.rule); },
        [](Asset& asset, Id entered) { asset.shaping.smallPieces.rule = static_cast<SmallPieceRule>(entered); });
    m_measure = addRow(tr("Measured by"), new QComboBox, tr("How the size of small fragments is measured"));
    addItem(*m_measure, PieceMeasure::FractionOfMean, tr("Fraction of Mean"));
    addItem(*m_measure, PieceMeasure::FractionOfWhole, tr("Fraction of Asset"));
    addItem(*m_measure, PieceMeasure::Area, tr("Area"));
    addItem(*m_measure, PieceMeasure::Volume, tr("Volume"));
    m_form.bind(
        m_measure, tr("Set Measure of Small Fragments"),
        [](const Asset& asset) { return static_cast<Id>(asset.shaping.smallPieces.measure); },
        [](Asset& asset, Id entered) {
            asset.shaping.smallPieces =
                withMeasure(asset.shaping.smallPieces, static_cast<PieceMeasure>(entered), asset);
        });
    const auto bindLimit = [this](auto* control) {
        m_form.bind(
            control, tr("Set Minimum Size"), [](const Asset& asset) { return asset.shaping.smallPieces.limit; },
            [](Asset& asset, double entered) { asset.shaping.smallPieces.limit = entered; });
        return control;
    };
    const FieldRange part = fieldRange(ProjectNumber::SmallPieceFraction, 0.05);
    m_fraction = bindLimit(addRow(tr("Minimum size"), new SliderField(part, 0.001, 1.0, SliderScale::Logarithmic),
                                  tr("Fraction below which fragments are small")));
    m_limit = bindLimit(addRow(tr("Minimum size"), new NumberField, tr("Size below which fragments are small")));
    m_limit->setRange(fieldRange(ProjectNumber::SmallPieceSize));
}

void ShapingSection::buildRoughness() {
    m_amplitude =
        addRow(tr("Roughness"), new NumberField,
               tr("Amplitude of bumps on fracture surfaces; affects rendering and export, not collision hulls"));
    m_amplitude->setRange(fieldRange(ProjectNumber::RoughnessAmplitude));
    m_form.bind(
        m_amplitude, tr("Set Roughness"), [](const Asset& asset) { return asset.shaping.roughness.amplitude; },
        [](Asset& asset, double entered) { asset.shaping.roughness.amplitude = entered; });
    auto* frequency =
        addRow(tr("Frequency"),
               new SliderField(fieldRange(ProjectNumber::RoughnessFrequency), 0.5, 200.0, SliderScale::Logarithmic),
               tr("Number of bumps per metre"));
    frequency->setFormat(Units::perMetre());
    m_form.bind(
        frequency, tr("Set Frequency"), [](const Asset& asset) { return asset.shaping.roughness.frequency; },
        [](Asset& asset, double entered) { asset.shaping.roughness.frequency = entered; });
    auto* octaves = addRow(tr("Octaves"), new SliderField(wholeFieldRange(ProjectNumber::RoughnessOctaves), 1, 8),
                           tr("Number of noise octaves, each with bumps half as large as the previous one"));
    m_form.bind(
        octaves, tr("Set Octaves"),
        [](const Asset& asset) { return static_cast<double>(asset.shaping.roughness.octaves); },
        [](Asset& asset, double entered) { asset.shaping.roughness.octaves = static_cast<std::uint32_t>(entered); });
    auto* randomSeed = addRow(tr("Random seed"), new RandomSeedField, tr("Random seed of the bumps"));
    m_form.bind(
        randomSeed, tr("Set Random Seed"),
        [](const Asset& asset) { return quint64{asset.shaping.roughness.randomSeed}; },
        [](Asset& asset, quint64 entered) { asset.shaping.roughness.randomSeed = entered; });
    m_roughnessRows = {frequency, octaves, randomSeed};
}

/// Hides rows without effect.
void ShapingSection::updateRows() {
    const std::vector<Asset> assets = selected();
    if (assets.empty()) return;
    const Shaping& shaping = assets[0].shaping;
    const bool isOn = shaping.smallPieces.rule != SmallPieceRule::Keep;
    setRowVisible(m_measure, isOn);
    setRowVisible(m_fraction, isOn && isFraction(shaping.smallPieces));
    setRowVisible(m_limit, isOn && !isFraction(shaping.smallPieces));
    const bool isVolume = shaping.smallPieces.measure == PieceMeasure::Volume;
    m_limit->setFormat(isVolume ? m_units.volumes() : m_units.areas());
    for (QWidget* control : m_roughnessRows) setRowVisible(control, shaping.roughness.amplitude > 0.0);
}

void ShapingSection::setUnits(const Units& units) {
    m_units = units;
    m_gap->setFormat(units.lengths());
    m_amplitude->setFormat(units.lengths());
    updateRows();
}

void ShapingSection::refresh() {
    updateRows();
    m_form.refresh();
}

}  // namespace rubble

#include "moc_ShapingSection.cpp"
