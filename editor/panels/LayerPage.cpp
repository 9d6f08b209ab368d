#include "editor/panels/LayerPage.h"

#include "editor/commands/LayerKind.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/LayerRows.h"
#include "editor/panels/PictureField.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

LayerPage::LayerPage(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_form(
          document, [this] { return chosen(); },
          [this](std::vector<PatternLayer> layers, const QString& text, quint64 stroke) {
              push(std::move(layers), text, stroke);
          }),
      m_common(new Section(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_common);
    buildPicture();
    buildRandomSeed();
    m_placed = m_common->addRow(tr("Seeds"), new QLabel, tr("Placed by hand; the canvas adds, moves and deletes them"));
    buildOverrides();
}

LayerPage::~LayerPage() = default;

void LayerPage::buildPicture() {
    m_picture = m_common->addRow(tr("Picture"), new PictureField,
                                 tr("The grey picture that seeds follow, stretched over the outline"));
    connect(m_picture, &PictureField::refused, this, &LayerPage::refused);
    connect(m_picture, &PictureField::chosen, this, [this](const PictureField::Picture& picture) {
        std::vector<PatternLayer> layers = chosen();
        for (PatternLayer& layer : layers) {
            if (auto* density = std::get_if<DensityImage>(&layer.parameters)) density->image = picture;
        }
        push(std::move(layers), tr("Choose picture"), 0);
    });
}

void LayerPage::buildRandomSeed() {
    m_randomSeed = m_common->addRow(tr("Random seed"), new RandomSeedField,
                                    tr("The same number scatters the same seeds, always and everywhere"));
    m_form.bind(
        m_randomSeed, tr("Throw the dice"), [](const PatternLayer& layer) { return quint64{layer.randomSeed}; },
        [](PatternLayer& layer, quint64 entered) { layer.randomSeed = entered; });
    connect(m_randomSeed, &RandomSeedField::refused, this, &LayerPage::refused);
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
    m_common->addRow(tr("By hand"), m_overrides, tr("Seeds of this scatter that were moved or deleted by hand"));
    connect(m_restore, &QPushButton::clicked, this, [this] {
        std::vector<PatternLayer> layers = chosen();
        for (PatternLayer& layer : layers) layer.overrides.clear();
        push(std::move(layers), tr("Restore seeds"), 0);
    });
}

/// The rows of the layer's kind; those of another kind make way.
LayerRows& LayerPage::rowsOf(const PatternLayer& layer) {
    const PatternKind& kind = kindOf(layer.parameters);
    if (!m_rows || &m_rows->kind() != &kind) {
        m_rows = std::make_unique<LayerRows>(
            kind, m_document, [this] { return chosen(); },
            [this](std::vector<PatternLayer> layers, const QString& text, quint64 stroke) {
                push(std::move(layers), text, stroke);
            });
        connect(m_rows.get(), &LayerRows::refused, this, &LayerPage::refused);
        static_cast<QVBoxLayout*>(layout())->insertWidget(0, m_rows.get());
        m_rows->setUnits(m_units);
        m_rows->show();
    }
    return *m_rows;
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

void LayerPage::setUnits(const Units& units) {
    m_units = units;
    if (m_rows) m_rows->setUnits(units);
}

/// m^2; of a level's fragments what one usually has.
double LayerPage::areaToFill() const {
    const Asset* asset = findAsset(m_document.project(), m_place.asset);
    if (!asset) return 1.0;
    const Vec2 whole = boundsToFill(*asset).size(), filled = boundsToFill(*asset, m_place.level).size();
    return area(asset->prism.outline) * (filled.x / whole.x) * (filled.y / whole.y);
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
    rowsOf(layer).refresh(layer, areaToFill());
    const bool scatters = kindOf(layer.parameters).role == LayerRole::Scatters;
    m_common->setRowVisible(m_randomSeed, scatters || std::holds_alternative<Slices>(layer.parameters));
    m_common->setRowVisible(m_overrides, scatters);
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
