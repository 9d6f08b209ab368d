#include "editor/panels/inspector/PatternEditor.h"

#include "core/asset/strength/Threshold.h"
#include "editor/commands/AssetPatterns.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/ProjectRange.h"
#include "editor/widgets/appearance/LayerText.h"

#include <QHBoxLayout>
#include <QListView>
#include <QMenu>
#include <QShortcut>
#include <QVBoxLayout>

#include <utility>

namespace rubble {

namespace {

constexpr int kVisibleRows = 5;

}  // namespace

PatternEditor::PatternEditor(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new LayerModel(document, this)),
      m_patterns(new QComboBox(this)),
      m_form(
          document, [this] { return selected(); }, pushOf<Asset>(document)),
      m_levelSettings(new Section(this)),
      m_minimumVolume(new NumberField),
      m_hasThreshold(new QCheckBox(tr("Override Threshold"))),
      m_threshold(thresholdField()),
      m_bondStrength(new SliderField(fieldRange(ProjectNumber::BondStrength), 0.1, 10.0, SliderScale::Logarithmic)),
      m_view(new QListView(this)),
      m_page(new LayerPage(document, this)) {
    buildView();
    buildLevelSettings();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(patternRow());
    layout->addWidget(m_levelSettings);
    layout->addWidget(m_view);
    layout->addWidget(buttonRow());
    layout->addSpacing(4);
    layout->addWidget(m_page);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        if (!current.isValid()) return;
        m_layer = m_model->layerAt(current.row());
        m_page->setLayer(m_pattern, m_layer);
    });
    connect(m_model, &LayerModel::modelReset, this, &PatternEditor::showCurrent);
    connect(m_model, &LayerModel::layerAdded, this, &PatternEditor::showLayer);
    connect(m_page, &LayerPage::refused, this, &PatternEditor::refused);
    m_form.setRefused([this](const QString& sentence) { emit refused(sentence); });
}

void PatternEditor::buildView() {
    m_view->setModel(m_model);
    m_view->setAccessibleName(tr("Layers"));
    m_view->setToolTip(tr("Drag layers, or press Alt+Up and Alt+Down, to change their order"));
    m_view->setUniformItemSizes(true);
    m_view->setDragDropMode(QAbstractItemView::InternalMove);
    m_view->setDefaultDropAction(Qt::MoveAction);
    const int rowHeight = m_view->fontMetrics().height() + 8;
    m_view->setFixedHeight(kVisibleRows * rowHeight + 2 * m_view->frameWidth());
    addMoveShortcut(Qt::Key_Up, -1);
    addMoveShortcut(Qt::Key_Down, 1);
}

void PatternEditor::buildLevelSettings() {
    m_levelSettings->addRow(tr("Minimum volume"), m_minimumVolume,
                            tr("Volume below which fragments are not fractured further"));
    m_minimumVolume->setRange(fieldRange(ProjectNumber::MinimumVolume));
    m_form.bind(
        m_minimumVolume, tr("Set Minimum Volume"),
        [this](const Asset& asset) {
            const Level* level = levelAt(asset, m_pattern.index);
            return level ? level->minimumVolume : 0.0;
        },
        [this](Asset& asset, double entered) { setMinimumVolume(asset, m_pattern.index, entered); });
    m_hasThreshold->setToolTip(
        tr("Give every fragment that breaks at this level the same threshold, instead of one "
           "that follows from its volume"));
    m_hasThreshold->setObjectName("override-level-threshold");
    m_levelSettings->addWide(m_hasThreshold);
    m_form.bind(
        m_hasThreshold, tr("Override Threshold of Level"),
        [this](const Asset& asset) { return levelThreshold(asset).has_value(); },
        [this](Asset& asset, bool isOn) {
            const double whole = thresholdOf(m_document.project(), asset);
            setLevelThreshold(asset, m_pattern.index,
                              isOn ? std::optional(levelThreshold(asset).value_or(whole)) : std::nullopt);
        });
    m_levelSettings->addRow(tr("Threshold"), m_threshold, tr("Impulse at which a fragment breaks at this level"));
    m_threshold->setAccessibleName(tr("Threshold of level"));
    m_form.bind(
        m_threshold, tr("Set Threshold of Level"),
        [this](const Asset& asset) { return levelThreshold(asset).value_or(thresholdOf(m_document.project(), asset)); },
        [this](Asset& asset, double entered) { setLevelThreshold(asset, m_pattern.index, entered); });
    m_levelSettings->addRow(tr("Bond strength"), m_bondStrength,
                            tr("Multiply the strength of the bonds between the fragments of this level"));
    m_bondStrength->setAccessibleName(tr("Bond strength of level"));
    m_form.bind(
        m_bondStrength, tr("Set Bond Strength of Level"),
        [this](const Asset& asset) {
            const Level* level = levelAt(asset, m_pattern.index);
            return level ? level->bondStrength : 1.0;
        },
        [this](Asset& asset, double entered) { setBondStrength(asset, m_pattern.index, entered); });
}

std::optional<double> PatternEditor::levelThreshold(const Asset& asset) const {
    const Level* level = levelAt(asset, m_pattern.index);
    return level ? level->threshold : std::nullopt;
}

QWidget* PatternEditor::patternRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    m_patterns->setAccessibleName(tr("Pattern"));
    m_patterns->setToolTip(tr("Pattern to edit: that of the asset, a fracture level or a single fragment"));
    auto* add = panelButton("add", tr("Add Level"), tr("Add a fracture level"), row);
    m_removeLevel =
        panelButton("remove", tr("Delete Level"), tr("Delete this level, or this fragment's own pattern"), row);
    layout->addWidget(m_patterns, 1);
    layout->addWidget(add);
    layout->addWidget(m_removeLevel);
    connect(m_patterns, &QComboBox::activated, this,
            [this](int index) { setPattern(static_cast<std::size_t>(index)); });
    connect(add, &QToolButton::clicked, this, [this] {
        if (selected().empty()) return;
        if (!m_document.push(addLevel(m_document.project(), m_pattern.asset))) return;
        setPattern(findAsset(m_document.project(), m_pattern.asset)->levels.size());
    });
    connect(m_removeLevel, &QToolButton::clicked, this, [this] {
        std::vector<Asset> assets = selected();
        if (assets.empty() || m_pattern.index == 0) return;
        removeLevelAt(assets[0], m_pattern.index);
        m_document.push(modify(tr("Delete Level"), std::move(assets[0])));
    });
    return row;
}

QWidget* PatternEditor::buttonRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* add = panelButton("layer-add", tr("Add Layer"), tr("Add a layer to the pattern"), row);
    auto* menu = new QMenu(add);
    menu->setToolTipsVisible(true);
    for (const PatternKind* kind : patternKinds()) {
        menuAction(*menu, kind->icon, inTitleCase(patternText(kind->caption)), patternText(kind->hint), [this, kind] {
            const std::vector<Asset> assets = selected();
            if (!assets.empty()) addLayer(kind->defaultsFor(domainBox(assets[0], m_pattern.index)));
        });
    }
    add->setMenu(menu);
    add->setPopupMode(QToolButton::InstantPopup);
    auto* duplicate =
        panelButton("edit-copy", tr("Duplicate Layer"), tr("Duplicate the layer with another random seed"), row);
    auto* up = panelButton("move-up", tr("Move Up"), tr("Move the layer up (Alt+Up)"), row);
    auto* down = panelButton("move-down", tr("Move Down"), tr("Move the layer down (Alt+Down)"), row);
    auto* remove = panelButton("edit-delete", tr("Delete Layer"), tr("Delete the layer"), row);
    for (QToolButton* button : {add, duplicate, up, down, remove}) layout->addWidget(button);
    layout->addStretch();
    connect(duplicate, &QToolButton::clicked, this, [this] {
        if (const Id copy = m_model->duplicate(m_layer)) showLayer(copy);
    });
    connect(up, &QToolButton::clicked, this, [this] { m_model->move(m_layer, -1); });
    connect(down, &QToolButton::clicked, this, [this] { m_model->move(m_layer, 1); });
    connect(remove, &QToolButton::clicked, this, [this] { m_model->remove(m_layer); });
    return row;
}

/// Moves the current layer on Alt and a key while the list has the focus.
void PatternEditor::addMoveShortcut(Qt::Key key, int by) {
    auto* shortcut = new QShortcut(QKeySequence(Qt::ALT | key), m_view, nullptr, nullptr, Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, [this, by] { m_model->move(m_layer, by); });
}

std::vector<Asset> PatternEditor::selected() const {
    const Asset* asset = findAsset(m_document.project(), m_pattern.asset);
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

void PatternEditor::setUnits(const Units& units) {
    m_model->setUnits(units);
    m_page->setUnits(units);
    m_minimumVolume->setFormat(units.volumes());
}

void PatternEditor::setPattern(std::size_t index) {
    m_pattern.index = index;
    showPattern();
}

void PatternEditor::addLayer(const LayerParameters& parameters) {
    if (selected().empty()) return;
    Addition addition = rubble::addLayer(m_document.project(), m_pattern.asset, parameters, m_pattern.index);
    if (!m_document.push(std::move(addition.edit))) return;
    m_model->refresh();
    showLayer(addition.id);
}

void PatternEditor::showLayer(Id layer) {
    m_layer = layer;
    showCurrent();
}

/// Shows the current layer, or the first if it is gone.
void PatternEditor::showCurrent() {
    const int row = std::max(m_model->rowOf(m_layer), 0);
    m_layer = m_model->layerAt(row);
    m_view->setCurrentIndex(m_model->index(row));
    m_page->setLayer(m_pattern, m_layer);
}

void PatternEditor::showPatternList() {
    const std::vector<Asset> assets = selected();
    const Asset none;
    const Asset& asset = assets.empty() ? none : assets[0];
    QStringList texts;
    for (std::size_t k = 0; k < patternCount(asset); ++k) texts.push_back(patternName(asset, k));
    if (m_pattern.index >= patternCount(asset)) m_pattern.index = 0;
    QStringList shown;
    for (int row = 0; row < m_patterns->count(); ++row) shown.push_back(m_patterns->itemText(row));
    if (shown != texts) {
        m_patterns->clear();
        m_patterns->addItems(texts);
    }
    m_patterns->setCurrentIndex(static_cast<int>(m_pattern.index));
    m_removeLevel->setEnabled(m_pattern.index > 0);
    const bool hasLevel = levelAt(asset, m_pattern.index) != nullptr;
    m_levelSettings->setVisible(hasLevel);
    if (!hasLevel) return;
    m_form.refresh();
    const bool isBonded = asset.breakAs == BreakAs::Bonded;
    m_hasThreshold->setVisible(!isBonded);
    m_levelSettings->setRowVisible(m_threshold, !isBonded && levelThreshold(asset).has_value());
    m_levelSettings->setRowVisible(m_bondStrength, isBonded);
}

void PatternEditor::refresh(Id asset, const FragmentPath& enteredFragment) {
    if (asset != m_pattern.asset) {
        m_pattern = {asset, 0};
        m_enteredPattern = 0;
    }
    const std::vector<Asset> assets = selected();
    const std::size_t enteredPattern = assets.empty() ? 0 : patternIndexFor(assets[0], enteredFragment);
    if (enteredPattern != std::exchange(m_enteredPattern, enteredPattern)) m_pattern.index = enteredPattern;
    showPattern();
}

void PatternEditor::showPattern() {
    showPatternList();
    m_model->setPattern(m_pattern);
    if (m_model->rowOf(m_layer) < 0) showCurrent();
    m_page->setLayer(m_pattern, m_layer);
}

}  // namespace rubble

#include "moc_PatternEditor.cpp"
