#include "editor/panels/inspector/LayerPage.h"

#include "core/asset/project/AssetShape.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/inspector/LayerSection.h"
#include "editor/panels/inspector/PictureField.h"
#include "editor/widgets/TypedFields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace rubble {

LayerPage::LayerPage(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_form(
          document, [this] { return selected(); },
          [this](std::vector<PatternLayer> layers, const QString& text, quint64 mergeKey) {
              push(std::move(layers), text, mergeKey);
          }),
      m_common(new Section(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_common);
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
    buildPicture();
    buildRandomSeed();
    m_placed = m_common->addRow(tr("Seeds"), new QLabel, tr("Number of seeds placed by hand in the canvas"));
    buildOverrides();
}

LayerPage::~LayerPage() = default;

void LayerPage::buildPicture() {
    m_picture =
        m_common->addRow(tr("Picture"), new PictureField,
                         tr("Greyscale picture that controls the density of seeds, stretched to fit the outline"));
    connect(m_picture, &PictureField::refused, this, &LayerPage::refused);
    connect(m_picture, &PictureField::reduced, this, &LayerPage::refused);
    connect(m_picture, &PictureField::picked, this, [this](const PictureField::Picture& picture) {
        std::vector<PatternLayer> layers = selected();
        for (PatternLayer& layer : layers) {
            if (auto* density = std::get_if<DensityImage>(&layer.parameters)) density->image = picture;
        }
        push(std::move(layers), tr("Set Picture"), 0);
    });
}

void LayerPage::buildRandomSeed() {
    m_randomSeed = m_common->addRow(tr("Random seed"), new RandomSeedField,
                                    tr("Start value of the random numbers; the same value gives the same seeds"));
    m_form.bind(
        m_randomSeed, tr("Set Random Seed"), [](const PatternLayer& layer) { return quint64{layer.randomSeed}; },
        [](PatternLayer& layer, quint64 entered) { layer.randomSeed = entered; });
}

void LayerPage::buildOverrides() {
    m_overrides = new QWidget;
    auto* layout = new QHBoxLayout(m_overrides);
    layout->setContentsMargins(0, 0, 0, 0);
    m_overridesText = new QLabel;
    m_overridesText->setWordWrap(true);
    m_restore = new QPushButton(tr("Restore Seeds"));
    m_restore->setToolTip(tr("Undo all moves and deletions of seeds in this layer"));
    m_restore->setStatusTip(m_restore->toolTip());
    m_restore->setAutoDefault(false);
    layout->addWidget(m_overridesText, 1);
    layout->addWidget(m_restore);
    m_common->addRow(tr("Overrides"), m_overrides, tr("Seeds of this layer that were moved or deleted by hand"));
    connect(m_restore, &QPushButton::clicked, this, [this] {
        std::vector<PatternLayer> layers = selected();
        for (PatternLayer& layer : layers) layer.overrides.clear();
        push(std::move(layers), tr("Restore Seeds"), 0);
    });
    m_scatterAnew = m_common->addRow(
        tr("Scattered in"), new QPushButton(tr("Scatter in Present Outline")),
        tr("The seeds stay where they were scattered before the outline was edited; scatter them in the present one"));
    m_scatterAnew->setAutoDefault(false);
    connect(m_scatterAnew, &QPushButton::clicked, this, [this] {
        std::vector<PatternLayer> layers = selected();
        for (PatternLayer& layer : layers) layer.scatteredIn.reset();
        push(std::move(layers), tr("Scatter in Present Outline"), 0);
    });
}

/// The parameters of the layer's kind; replaces those of another kind.
LayerSection& LayerPage::sectionFor(const PatternLayer& layer) {
    const PatternKind& kind = kindOf(layer.parameters);
    if (!m_parameters || &m_parameters->kind() != &kind) {
        m_parameters = std::make_unique<LayerSection>(
            kind, m_document, [this] { return selected(); },
            [this](std::vector<PatternLayer> layers, const QString& text, quint64 mergeKey) {
                push(std::move(layers), text, mergeKey);
            });
        connect(m_parameters.get(), &LayerSection::refused, this, &LayerPage::refused);
        static_cast<QVBoxLayout*>(layout())->insertWidget(0, m_parameters.get());
        m_parameters->setUnits(m_units);
        m_parameters->show();
    }
    return *m_parameters;
}

std::vector<PatternLayer> LayerPage::selected() const {
    const Pattern* pattern = findPattern(m_document.project(), m_pattern);
    if (!pattern) return {};
    const auto layer = std::ranges::find(pattern->layers, m_layer, &PatternLayer::id);
    return layer == pattern->layers.end() ? std::vector<PatternLayer>{} : std::vector{*layer};
}

void LayerPage::push(std::vector<PatternLayer> layers, const QString& text, quint64 mergeKey) {
    if (layers.empty()) return;
    Pattern pattern = *findPattern(m_document.project(), m_pattern);
    *std::ranges::find(pattern.layers, m_layer, &PatternLayer::id) = std::move(layers.front());
    m_document.push(modify(text, withPattern(m_document.project(), m_pattern, std::move(pattern)), mergeKey));
}

void LayerPage::setLayer(PatternRef pattern, Id layer) {
    if (layer != m_layer) discardTyping(*this);  // it was meant for the other layer
    m_pattern = pattern;
    m_layer = layer;
    refresh();
}

void LayerPage::setUnits(const Units& units) {
    m_units = units;
    if (m_parameters) m_parameters->setUnits(units);
}

SeedSpace LayerPage::space() const {
    const Asset* asset = findAsset(m_document.project(), m_pattern.asset);
    return asset && !asset->isPrism() ? SeedSpace::Solid : SeedSpace::Plane;
}

/// The area in m², or of a mesh the volume in m³, that the layer fills; an estimate for a fragment of a level.
double LayerPage::domainSize(const PatternLayer& layer) const {
    if (layer.scatteredIn) return area(*layer.scatteredIn);
    const Asset* asset = findAsset(m_document.project(), m_pattern.asset);
    if (!asset) return 1.0;
    const Vec2 whole = domainBounds(*asset).size(), filled = domainBounds(*asset, m_pattern.index).size();
    if (!asset->isPrism()) return volumeOf(*asset) * std::pow(filled.x / whole.x, 3.0);
    return area(asset->prism().outline) * (filled.x / whole.x) * (filled.y / whole.y);
}

void LayerPage::showOverrides(const PatternLayer& layer) {
    const auto deleted = std::ranges::count_if(layer.overrides, &SeedOverride::isDeleted);
    const auto moved = static_cast<std::ptrdiff_t>(layer.overrides.size()) - deleted;
    m_overridesText->setText(layer.overrides.empty() ? tr("None") : tr("%1 moved, %2 deleted").arg(moved).arg(deleted));
    m_restore->setEnabled(!layer.overrides.empty());
}

void LayerPage::refresh() {
    const std::vector<PatternLayer> layers = selected();
    setVisible(!layers.empty());
    if (layers.empty()) return;
    const PatternLayer& layer = layers.front();
    sectionFor(layer).refresh(layer, domainSize(layer), space());
    const PatternKind& kind = kindOf(layer.parameters);
    m_common->setRowVisible(m_randomSeed, kind.isRandom);
    m_common->setRowVisible(m_scatterAnew, layer.scatteredIn.has_value());
    m_common->setRowVisible(m_overrides, kind.role == LayerRole::Scatters);
    const auto* density = std::get_if<DensityImage>(&layer.parameters);
    m_common->setRowVisible(m_picture, density != nullptr);
    if (density) m_picture->setPicture(density->image);
    const auto* placed = std::get_if<PlacedSeeds>(&layer.parameters);
    m_common->setRowVisible(m_placed, placed != nullptr);
    if (placed) m_placed->setText(locale().toString(static_cast<qulonglong>(placed->seeds.size())));
    showOverrides(layer);
    m_form.refresh();
}

}  // namespace rubble

#include "moc_LayerPage.cpp"
