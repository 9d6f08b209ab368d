#include "editor/panels/LayerPage.h"

#include "editor/commands/ProjectEdits.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr double kMostUsualSeeds = 2000.0;     // the sliders' ends
constexpr double kLeastUsualDistance = 0.005;  // m
constexpr double kMostUsualDistance = 2.0;     // m
constexpr double kMostUsualRounds = 20.0;
constexpr double kMostRounds = 10'000.0;

template <class Kind>
bool isKind(const PatternLayer& layer) {
    return std::holds_alternative<Kind>(layer.parameters);
}

/// Reads a member of one kind of layer; its usual value where the layer is of another.
template <class Kind, class Member>
auto reading(Member Kind::*member) {
    return [member](const PatternLayer& layer) {
        const auto* parameters = std::get_if<Kind>(&layer.parameters);
        return static_cast<double>((parameters ? *parameters : Kind{}).*member);
    };
}

template <class Kind, class Member>
auto writing(Member Kind::*member) {
    return [member](PatternLayer& layer, double value) {
        if (auto* parameters = std::get_if<Kind>(&layer.parameters)) parameters->*member = static_cast<Member>(value);
    };
}

Id domainOf(const PatternLayer& layer) {
    if (const auto* noise = std::get_if<BlueNoise>(&layer.parameters)) return static_cast<Id>(noise->domain);
    const auto* uniform = std::get_if<UniformScatter>(&layer.parameters);
    return static_cast<Id>(uniform ? uniform->domain : ScatterDomain::Outline);
}

void setDomain(PatternLayer& layer, Id domain) {
    if (auto* noise = std::get_if<BlueNoise>(&layer.parameters)) noise->domain = static_cast<ScatterDomain>(domain);
    if (auto* uniform = std::get_if<UniformScatter>(&layer.parameters)) {
        uniform->domain = static_cast<ScatterDomain>(domain);
    }
}

}  // namespace

LayerPage::LayerPage(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_form(
          document, [this] { return chosen(); },
          [this](std::vector<PatternLayer> layers, const QString& text, quint64 stroke) {
              push(std::move(layers), text, stroke);
          }),
      m_rows(new Section(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_rows);
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    m_form.setFault(
        [](const PatternLayer& layer) { return QString::fromStdString(verifyPattern(Pattern{{layer}}).value_or("")); });
    buildScatters();
    buildOverrides();
}

void LayerPage::buildScatters() {
    m_count = m_rows->addRow(
        tr("Count"),
        new SliderField(FieldRange::whole(0.0, kMostSeeds), 1.0, kMostUsualSeeds, SliderScale::Logarithmic),
        tr("How many seeds are thrown; more leave the earlier ones where they are"));
    m_form.bind(m_count, tr("Set count"), reading(&UniformScatter::count), writing(&UniformScatter::count));
    m_distance = m_rows->addRow(
        tr("Distance"),
        new SliderField(FieldRange::aboveZero(), kLeastUsualDistance, kMostUsualDistance, SliderScale::Logarithmic),
        tr("No two seeds are nearer to each other than this"));
    m_form.bind(m_distance, tr("Set distance"), reading(&BlueNoise::minimumDistance),
                writing(&BlueNoise::minimumDistance));
    m_most = m_rows->addRow(tr("At most"), new NumberField, tr("How many seeds; 0: as many as find room"));
    m_most->setRange(FieldRange::whole(0.0, kMostSeeds));
    m_form.bind(m_most, tr("Set count"), reading(&BlueNoise::count), writing(&BlueNoise::count));
    m_domain =
        m_rows->addRow(tr("Where"), new QComboBox, tr("Inside the outline, or in its bounding box as the thesis does"));
    m_domain->addItem(tr("Outline"), static_cast<Id>(ScatterDomain::Outline));
    m_domain->addItem(tr("Bounding box"), static_cast<Id>(ScatterDomain::BoundingBox));
    m_form.bind(m_domain, tr("Set domain"), domainOf, setDomain);
    m_rounds = m_rows->addRow(tr("Rounds"), new SliderField(FieldRange::whole(0.0, kMostRounds), 0.0, kMostUsualRounds),
                              tr("How often the seeds above move to the middle of their cells: more make cells even"));
    m_form.bind(m_rounds, tr("Set rounds"), reading(&LloydRelaxation::rounds), writing(&LloydRelaxation::rounds));
    m_randomSeed = m_rows->addRow(tr("Random seed"), new RandomSeedField,
                                  tr("The same number scatters the same seeds, always and everywhere"));
    m_form.bind(
        m_randomSeed, tr("Throw the dice"), [](const PatternLayer& layer) { return quint64{layer.randomSeed}; },
        [](PatternLayer& layer, quint64 entered) { layer.randomSeed = entered; });
    connect(m_randomSeed, &RandomSeedField::refused, this, &LayerPage::refused);
    m_placed = m_rows->addRow(tr("Seeds"), new QLabel, tr("Placed by hand; the canvas adds, moves and deletes them"));
}

void LayerPage::buildOverrides() {
    m_overrides = new QWidget;
    auto* layout = new QHBoxLayout(m_overrides);
    layout->setContentsMargins(0, 0, 0, 0);
    m_overridesText = new QLabel;
    m_overridesText->setWordWrap(true);
    m_restore = new QPushButton(tr("Restore"));
    m_restore->setToolTip(tr("Take back all that was moved or deleted by hand in this layer"));
    m_restore->setStatusTip(m_restore->toolTip());
    m_restore->setAutoDefault(false);
    layout->addWidget(m_overridesText, 1);
    layout->addWidget(m_restore);
    m_rows->addRow(tr("By hand"), m_overrides, tr("Seeds of this scatter that were moved or deleted by hand"));
    connect(m_restore, &QPushButton::clicked, this, [this] {
        std::vector<PatternLayer> layers = chosen();
        for (PatternLayer& layer : layers) layer.overrides.clear();
        push(std::move(layers), tr("Restore seeds"), 0);
    });
}

std::vector<PatternLayer> LayerPage::chosen() const {
    const Pattern* pattern = findPattern(m_document.project(), m_place);
    if (!pattern) return {};
    const auto layer = std::ranges::find(pattern->layers, m_layer, &PatternLayer::id);
    return layer == pattern->layers.end() ? std::vector<PatternLayer>{} : std::vector{*layer};
}

void LayerPage::push(std::vector<PatternLayer> layers, const QString& text, quint64 stroke) {
    if (layers.empty()) return;
    Pattern pattern = *findPattern(m_document.project(), m_place);
    *std::ranges::find(pattern.layers, m_layer, &PatternLayer::id) = std::move(layers.front());
    m_document.push(altered(text, withPattern(m_document.project(), m_place, std::move(pattern)), stroke));
}

void LayerPage::setLayer(PatternPlace place, Id layer) {
    m_place = place;
    m_layer = layer;
    refresh();
}

void LayerPage::showOverrides(const PatternLayer& layer) {
    const auto deleted = std::ranges::count_if(layer.overrides, &SeedOverride::isDeleted);
    const auto moved = static_cast<std::ptrdiff_t>(layer.overrides.size()) - deleted;
    m_overridesText->setText(layer.overrides.empty() ? tr("no seed")
                                                     : tr("%1 moved, %2 deleted").arg(moved).arg(deleted));
    m_restore->setEnabled(!layer.overrides.empty());
}

void LayerPage::refresh() {
    const std::vector<PatternLayer> layers = chosen();
    setVisible(!layers.empty());
    if (layers.empty()) return;
    const PatternLayer& layer = layers.front();
    const bool isNoise = isKind<BlueNoise>(layer);
    const bool isUniform = isKind<UniformScatter>(layer);
    m_rows->setRowVisible(m_count, isUniform);
    m_rows->setRowVisible(m_distance, isNoise);
    m_rows->setRowVisible(m_most, isNoise);
    m_rows->setRowVisible(m_domain, isNoise || isUniform);
    m_rows->setRowVisible(m_randomSeed, isNoise || isUniform);
    m_rows->setRowVisible(m_overrides, isNoise || isUniform);
    m_rows->setRowVisible(m_rounds, isKind<LloydRelaxation>(layer));
    m_rows->setRowVisible(m_placed, isKind<PlacedSeeds>(layer));
    if (const auto* placed = std::get_if<PlacedSeeds>(&layer.parameters)) {
        m_placed->setText(locale().toString(static_cast<qulonglong>(placed->seeds.size())));
    }
    showOverrides(layer);
    m_form.refresh();
}

}  // namespace rubble
