#include "editor/panels/PatternEditor.h"

#include "editor/commands/PatternPlaces.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/panels/Icons.h"
#include "editor/panels/LayerText.h"

#include <QHBoxLayout>
#include <QListView>
#include <QMenu>
#include <QShortcut>
#include <QVBoxLayout>

#include <utility>

namespace rubble {

namespace {

constexpr int kRowsShown = 5;

}  // namespace

PatternEditor::PatternEditor(Document& document, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_model(new LayerModel(document, this)),
      m_levels(new QComboBox(this)),
      m_form(
          document, [this] { return chosen(); }, pushOf<Asset>(document)),
      m_ofLevel(new Section(this)),
      m_minimumVolume(new NumberField),
      m_view(new QListView(this)),
      m_page(new LayerPage(document, this)) {
    m_view->setModel(m_model);
    m_view->setAccessibleName(tr("Layers"));
    m_view->setToolTip(tr("Layers of seeds, carried out from top to bottom; drag them, or Alt+Up and Alt+Down"));
    m_view->setUniformItemSizes(true);
    m_view->setDragDropMode(QAbstractItemView::InternalMove);
    m_view->setDefaultDropAction(Qt::MoveAction);
    m_ofLevel->addRow(tr("From volume"), m_minimumVolume, tr("Fragments smaller than this are not broken again"));
    m_minimumVolume->setRange(FieldRange::zeroOrAbove());
    m_form.bind(
        m_minimumVolume, tr("Set minimum volume"),
        [this](const Asset& asset) {
            const Level* level = levelAt(asset, m_place.level);
            return level ? level->minimumVolume : 0.0;
        },
        [this](Asset& asset, double entered) { setMinimumVolume(asset, m_place.level, entered); });

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(levelRow());
    layout->addWidget(m_ofLevel);
    layout->addWidget(m_view);
    layout->addWidget(buttonRow());
    layout->addSpacing(4);
    layout->addWidget(m_page);
    const int rowHeight = m_view->fontMetrics().height() + 8;
    m_view->setFixedHeight(kRowsShown * rowHeight + 2 * m_view->frameWidth());

    addMove(Qt::Key_Up, -1);
    addMove(Qt::Key_Down, 1);
    connect(m_view->selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& current) {
        if (!current.isValid()) return;
        m_layer = m_model->layerAt(current.row());
        m_page->setLayer(m_place, m_layer);
    });
    connect(m_model, &LayerModel::modelReset, this, &PatternEditor::showCurrent);
    connect(m_page, &LayerPage::refused, this, &PatternEditor::refused);
}

QWidget* PatternEditor::levelRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    m_levels->setAccessibleName(tr("Level"));
    m_levels->setToolTip(tr("What is broken: the whole, the fragments of the level before, or a single one"));
    auto* add = panelButton("add", tr("Add level"), tr("Break the fragments once more: add a level"), row);
    m_removeLevel = panelButton("remove", tr("Delete level"),
                                tr("Delete the level that is shown, or what is said of a single fragment"), row);
    layout->addWidget(m_levels, 1);
    layout->addWidget(add);
    layout->addWidget(m_removeLevel);
    connect(m_levels, &QComboBox::activated, this, [this](int level) { setLevel(static_cast<std::size_t>(level)); });
    connect(add, &QToolButton::clicked, this, [this] {
        if (chosen().empty()) return;
        m_document.push(addLevel(m_document.project(), m_place.asset));
        setLevel(findAsset(m_document.project(), m_place.asset)->levels.size());
    });
    connect(m_removeLevel, &QToolButton::clicked, this, [this] {
        std::vector<Asset> assets = chosen();
        if (assets.empty() || m_place.level == 0) return;
        removeLevelAt(assets[0], m_place.level);
        m_document.push(altered(tr("Delete level"), std::move(assets[0])));
    });
    return row;
}

QWidget* PatternEditor::buttonRow() {
    auto* row = new QWidget(this);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    auto* add = panelButton("layer-add", tr("Add layer"), tr("Add a layer of seeds"), row);
    auto* menu = new QMenu(add);
    menu->setToolTipsVisible(true);
    for (const PatternKind* kind : patternKinds()) {
        const LayerParameters usual = kind->suitedTo({{0.0, 0.0}, {1.0, 1.0}});
        menuAction(*menu, kindIconName(usual), patternText(kind->caption), patternText(kind->hint), [this, kind] {
            const std::vector<Asset> assets = chosen();
            if (!assets.empty()) addLayer(kind->suitedTo(boundsToFill(assets[0], m_place.level)));
        });
    }
    add->setMenu(menu);
    add->setPopupMode(QToolButton::InstantPopup);
    auto* duplicate = panelButton("edit-copy", tr("Duplicate"), tr("Add a copy with another random seed"), row);
    auto* up = panelButton("move-up", tr("Up"), tr("Carry the layer out earlier (Alt+Up)"), row);
    auto* down = panelButton("move-down", tr("Down"), tr("Carry the layer out later (Alt+Down)"), row);
    auto* remove = panelButton("edit-delete", tr("Delete layer"), tr("Delete the layer"), row);
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

/// Has a key with Alt move the current layer by rows while the list has the focus.
void PatternEditor::addMove(Qt::Key key, int by) {
    auto* shortcut = new QShortcut(QKeySequence(Qt::ALT | key), m_view, nullptr, nullptr, Qt::WidgetShortcut);
    connect(shortcut, &QShortcut::activated, this, [this, by] { m_model->move(m_layer, by); });
}

std::vector<Asset> PatternEditor::chosen() const {
    const Asset* asset = findAsset(m_document.project(), m_place.asset);
    return asset ? std::vector{*asset} : std::vector<Asset>{};
}

void PatternEditor::setUnits(const Units& units) {
    m_model->setUnits(units);
    m_page->setUnits(units);
    m_minimumVolume->setFormat(units.volumes());
}

void PatternEditor::setLevel(std::size_t level) {
    m_place.level = level;
    showPlace();
}

void PatternEditor::addLayer(const LayerParameters& parameters) {
    if (chosen().empty()) return;
    Addition addition = rubble::addLayer(m_document.project(), m_place.asset, parameters, m_place.level);
    m_document.push(std::move(addition.edit));
    m_model->refresh();
    showLayer(addition.id);
}

void PatternEditor::showLayer(Id layer) {
    m_layer = layer;
    showCurrent();
}

/// The current layer, or the one that took its place.
void PatternEditor::showCurrent() {
    const int row = std::max(m_model->rowOf(m_layer), 0);
    m_layer = m_model->layerAt(row);
    m_view->setCurrentIndex(m_model->index(row));
    m_page->setLayer(m_place, m_layer);
}

void PatternEditor::showLevels() {
    const std::vector<Asset> assets = chosen();
    const Asset none;
    const Asset& asset = assets.empty() ? none : assets[0];
    QStringList texts;
    for (std::size_t place = 0; place < patternCount(asset); ++place) texts.push_back(placeText(asset, place));
    if (m_place.level >= patternCount(asset)) m_place.level = 0;
    QStringList shown;
    for (int row = 0; row < m_levels->count(); ++row) shown.push_back(m_levels->itemText(row));
    if (shown != texts) {
        m_levels->clear();
        m_levels->addItems(texts);
    }
    m_levels->setCurrentIndex(static_cast<int>(m_place.level));
    m_removeLevel->setEnabled(m_place.level > 0);
    const bool isOfLevel = levelAt(asset, m_place.level) != nullptr;
    m_ofLevel->setVisible(isOfLevel);
    if (isOfLevel) m_form.refresh();
}

void PatternEditor::refresh(Id asset, const FragmentPath& inside) {
    if (asset != m_place.asset) {
        m_place = {asset, 0};
        m_insideLevel = 0;
    }
    const std::vector<Asset> assets = chosen();
    const std::size_t insideLevel = assets.empty() ? 0 : placeFor(assets[0], inside);
    if (insideLevel != std::exchange(m_insideLevel, insideLevel)) m_place.level = insideLevel;
    showPlace();
}

void PatternEditor::showPlace() {
    showLevels();
    m_model->setPlace(m_place);
    if (m_model->rowOf(m_layer) < 0) showCurrent();
    m_page->setLayer(m_place, m_layer);
}

}  // namespace rubble
