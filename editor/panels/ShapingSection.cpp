#include "editor/panels/ShapingSection.h"

#include "editor/document/Selection.h"

namespace rubble {

namespace {

template <class Value>
void setIn(QComboBox& box, Value value, const QString& text) {
    box.addItem(text, static_cast<Id>(value));
}

bool isPart(const SmallPieces& small) {
    return small.measure == PieceMeasure::PartOfMean || small.measure == PieceMeasure::PartOfWhole;
}

/// Another measure's limit says something else; what a user means by it begins with a usual one.
SmallPieces withMeasure(SmallPieces small, PieceMeasure measure, const Prism& prism) {
    const bool wasPart = isPart(small);
    small.measure = measure;
    if (isPart(small) == wasPart && wasPart) return small;
    constexpr double kUsualPart = 0.1, kUsualShare = 0.001;  // of the mean; of the whole
    small.limit = isPart(small) ? kUsualPart : kUsualShare * area(prism.outline);
    if (measure == PieceMeasure::Volume) small.limit *= prism.depth;
    return small;
}

}  // namespace

ShapingSection::ShapingSection(Document& document, const Selection& selection, QWidget* parent)
    : Section("pieces", tr("Pieces"), parent),
      m_document(document),
      m_selection(selection),
      m_form(
          document, [this] { return chosen(); }, pushOf<Asset>(document)) {
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault([](const Asset& asset) {
        return QString::fromStdString(verifyShaping(asset.shaping).value_or(std::string()));
    });
    buildSmallPieces();
    m_gap = addRow(tr("Gap"), new NumberField,
                   tr("How wide the space between pieces is: each is shrunk by half of it along its cuts"));
    m_gap->setRange(FieldRange::zeroOrAbove());
    m_form.bind(
        m_gap, tr("Set gap"), [](const Asset& asset) { return asset.shaping.gap; },
        [](Asset& asset, double entered) { asset.shaping.gap = entered; });
    buildRoughness();
}

std::vector<Asset> ShapingSection::chosen() const {
    const Asset* asset = findAsset(m_document.project(), m_selection.asset());
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

void ShapingSection::buildSmallPieces() {
    auto* rule = addRow(tr("Small pieces"), new QComboBox, tr("What becomes of pieces below a size"));
    setIn(*rule, SmallPieceRule::Keep, tr("Keep"));
    setIn(*rule, SmallPieceRule::Merge, tr("Merge"));
    setIn(*rule, SmallPieceRule::DropSeeds, tr("Drop their seeds"));
    m_form.bind(
        rule, tr("Set small pieces"),
        [](const Asset& asset) { return static_cast<Id>(asset.shaping.smallPieces.rule); },
        [](Asset& asset, Id entered) { asset.shaping.smallPieces.rule = static_cast<SmallPieceRule>(entered); });
    m_measure = addRow(tr("Smallest by"), new QComboBox, tr("How the size of the smallest piece is given"));
    setIn(*m_measure, PieceMeasure::PartOfMean, tr("Part of the mean"));
    setIn(*m_measure, PieceMeasure::PartOfWhole, tr("Part of the whole"));
    setIn(*m_measure, PieceMeasure::Area, tr("Area"));
    setIn(*m_measure, PieceMeasure::Volume, tr("Volume"));
    m_form.bind(
        m_measure, tr("Set measure of small pieces"),
        [](const Asset& asset) { return static_cast<Id>(asset.shaping.smallPieces.measure); },
        [](Asset& asset, Id entered) {
            asset.shaping.smallPieces =
                withMeasure(asset.shaping.smallPieces, static_cast<PieceMeasure>(entered), asset.prism);
        });
    const auto bindLimit = [this](auto* control) {
        m_form.bind(
            control, tr("Set smallest piece"), [](const Asset& asset) { return asset.shaping.smallPieces.limit; },
            [](Asset& asset, double entered) { asset.shaping.smallPieces.limit = entered; });
        return control;
    };
    const FieldRange part{.min = 0.0, .max = 1.0, .isMinOut = true, .step = 0.05};
    m_part = bindLimit(addRow(tr("Smallest"), new SliderField(part, 0.001, 1.0, SliderScale::Logarithmic),
                              tr("Pieces below this part are too small")));
    m_limit = bindLimit(addRow(tr("Smallest"), new NumberField, tr("Pieces below this size are too small")));
    m_limit->setRange(FieldRange::aboveZero());
}

void ShapingSection::buildRoughness() {
    m_amplitude =
        addRow(tr("Roughness"), new NumberField,
               tr("How far cuts stand out and in where pieces are drawn and exported; hulls stay as they are"));
    m_amplitude->setRange(FieldRange::zeroOrAbove());
    m_form.bind(
        m_amplitude, tr("Set roughness"), [](const Asset& asset) { return asset.shaping.roughness.amplitude; },
        [](Asset& asset, double entered) { asset.shaping.roughness.amplitude = entered; });
    auto* frequency =
        addRow(tr("Frequency"), new SliderField(FieldRange::aboveZero(), 0.5, 200.0, SliderScale::Logarithmic),
               tr("How many bumps there are on a metre of a cut"));
    frequency->setFormat({tr("per m"), 0});
    m_form.bind(
        frequency, tr("Set frequency"), [](const Asset& asset) { return asset.shaping.roughness.frequency; },
        [](Asset& asset, double entered) { asset.shaping.roughness.frequency = entered; });
    auto* octaves = addRow(tr("Octaves"), new SliderField(FieldRange::whole(1, Roughness::kMostOctaves), 1, 8),
                           tr("How many sizes of bumps there are, each half as large as the one before"));
    m_form.bind(
        octaves, tr("Set octaves"),
        [](const Asset& asset) { return static_cast<double>(asset.shaping.roughness.octaves); },
        [](Asset& asset, double entered) { asset.shaping.roughness.octaves = static_cast<std::uint32_t>(entered); });
    auto* randomSeed = addRow(tr("Bumps seed"), new RandomSeedField, tr("Another one gives other bumps"));
    m_form.bind(
        randomSeed, tr("Set random seed"),
        [](const Asset& asset) { return quint64{asset.shaping.roughness.randomSeed}; },
        [](Asset& asset, quint64 entered) { asset.shaping.roughness.randomSeed = entered; });
    m_ofRoughness = {frequency, octaves, randomSeed};
}

/// Rows that change nothing are not shown.
void ShapingSection::showUsed() {
    const std::vector<Asset> assets = chosen();
    if (assets.empty()) return;
    const Shaping& shaping = assets[0].shaping;
    const bool areSmall = shaping.smallPieces.rule != SmallPieceRule::Keep;
    setRowVisible(m_measure, areSmall);
    setRowVisible(m_part, areSmall && isPart(shaping.smallPieces));
    setRowVisible(m_limit, areSmall && !isPart(shaping.smallPieces));
    const bool isVolume = shaping.smallPieces.measure == PieceMeasure::Volume;
    m_limit->setFormat(isVolume ? m_units.volumes() : m_units.areas());
    for (QWidget* control : m_ofRoughness) setRowVisible(control, shaping.roughness.amplitude > 0.0);
}

void ShapingSection::setUnits(const Units& units) {
    m_units = units;
    m_gap->setFormat(units.lengths());
    m_amplitude->setFormat(units.lengths());
    showUsed();
}

void ShapingSection::refresh() {
    showUsed();
    m_form.refresh();
}

}  // namespace rubble
