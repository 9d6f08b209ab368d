#include "editor/dialogs/sheet/ContactSheetWindow.h"

#include "core/asset/project/Ranges.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateFile.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/MessageBoxes.h"
#include "editor/dialogs/sheet/ContactSheetText.h"
#include "editor/dialogs/sheet/VariantDelegate.h"
#include "editor/dialogs/sheet/VariationTree.h"
#include "editor/document/FilePath.h"
#include "editor/document/ShownText.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/ScreenFit.h"
#include "editor/widgets/StateField.h"
#include "editor/workspace/ViewportStyle.h"
#include "editor/workspace/Workspace.h"

#include <QCloseEvent>
#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <map>
#include <set>

namespace rubble {

namespace {

constexpr QSize kPictureSize{240, 180};
constexpr QSize kSheetSize{1180, 760};
constexpr int kSettingsWidth = 300;  // pixels
constexpr int kProgressWidth = 160;  // pixels
constexpr int kDefaultVariants = 12;
constexpr int kDefaultStep = 60;    // one second after the start
constexpr int kDefaultSpread = 15;  // per cent
constexpr int kMaxSpread = 90;      // per cent
constexpr int kNumberRole = Qt::UserRole;
constexpr std::chrono::milliseconds kRefreshDelay{400};  // after the last edit of a drag

QPushButton* createButton(const char* icon, const QString& text, const QString& tip) {
    auto* button = new QPushButton(iconNamed(icon), text);
    button->setToolTip(tip);
    button->setAutoDefault(false);
    return button;
}

void setRange(QSpinBox& box, ProjectNumber number) {
    const NumberRange& range = rangeOf(number);
    box.setRange(static_cast<int>(range.min), static_cast<int>(range.max));
}

/// Returns the picture of a variant, or an error icon if it has none.
QPixmap pictureOf(const SheetCell& cell, double ratio) {
    if (cell.image.isNull()) return iconNamed("message-error").pixmap(kPictureSize / 3, ratio);
    QPixmap pixmap = QPixmap::fromImage(cell.image);
    pixmap.setDevicePixelRatio(ratio);
    return pixmap;
}

}  // namespace

ContactSheetWindow::ContactSheetWindow(Workspace& workspace, const Units& units, QWidget* parent)
    : QWidget(parent, Qt::Window),
      m_workspace(workspace),
      m_units(units),
      m_asset(workspace.selection().asset()),
      m_variations(new VariationTree),
      m_variants(new QSpinBox),
      m_spread(new QSpinBox),
      m_shot(new QComboBox),
      m_state(new StateField(workspace.file())),
      m_step(new QSpinBox),
      m_sort(new QComboBox),
      m_list(new QListWidget),
      m_summary(new QLabel),
      m_progress(new QProgressBar),
      m_reseed(createButton("dice", tr("&Reseed"), tr("Generate variants with new random seeds"))),
      m_lock(createButton("sheet-lock", tr("&Lock Selected Seeds"), tr("Lock the selected seeds in all new variants"))),
      m_crossOver(createButton("sheet-crossover", tr("Cross &Over"), tr("Generate children of the selected variants"))),
      m_apply(createButton("sheet-apply", tr("A&pply"), tr("Apply the selected variant to the asset"))),
      m_cancel(createButton("remove", tr("&Cancel"), tr("Cancel and keep the finished variants"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("contact-sheet");
    resizeWithinScreen(*this, kSheetSize);
    auto* columns = new QHBoxLayout(this);
    columns->addWidget(createSettings());
    auto* rows = new QVBoxLayout;
    rows->addWidget(m_list, 1);
    rows->addWidget(createBar());
    columns->addLayout(rows, 1);
    setUpList();
    connectSignals();
    updateDocument();
    m_list->setFocus();
}

const Asset* ContactSheetWindow::asset() const { return findAsset(m_workspace.project(), m_asset); }

void ContactSheetWindow::setUpList() {
    m_list->setViewMode(QListView::IconMode);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setIconSize(kPictureSize);
    m_list->setSpacing(8);
    m_list->setUniformItemSizes(false);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setWordWrap(true);
    m_list->setItemDelegate(new VariantDelegate(m_list));
    m_list->setAccessibleName(tr("Variants"));
    m_list->setObjectName("sheet-list");
}

void ContactSheetWindow::connectSignals() {
    connect(m_list, &QListWidget::itemActivated, this, &ContactSheetWindow::apply);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &ContactSheetWindow::updateState);
    connect(m_sort, &QComboBox::currentIndexChanged, this, &ContactSheetWindow::sort);
    connectSettings();
    connect(m_reseed, &QPushButton::clicked, this, [this] {
        ++m_randomSeed;
        generate();
    });
    connect(m_lock, &QPushButton::clicked, this, &ContactSheetWindow::lockSelected);
    connect(m_cancel, &QPushButton::clicked, &m_generator, &ContactSheetGenerator::cancel);
    connect(m_crossOver, &QPushButton::clicked, this, &ContactSheetWindow::crossOver);
    connect(m_apply, &QPushButton::clicked, this, &ContactSheetWindow::apply);
    connect(&m_generator, &ContactSheetGenerator::cellReady, this, &ContactSheetWindow::add);
    connect(&m_generator, &ContactSheetGenerator::changed, this, &ContactSheetWindow::updateState);
    connect(&m_generator, &ContactSheetGenerator::failed, this, &ContactSheetWindow::showMessage);
    connect(&m_generator, &ContactSheetGenerator::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&m_workspace.document(), &Document::changed, this, [this](const Changes& changes) {
        updateDocument();
        const bool isOfSheet =
            changes.touches(Part::Asset, m_asset) || changes.touches(Part::Material) || changes.touches(Part::Shot);
        if (!isOfSheet || m_isApplying) return;
        m_parents.clear();
        refreshLater();
    });
    m_refresh.setSingleShot(true);
    m_refresh.setInterval(kRefreshDelay);
    connect(&m_refresh, &QTimer::timeout, this, &ContactSheetWindow::refresh);
}

/// The sheet follows its settings, after the last keystroke.
void ContactSheetWindow::connectSettings() {
    connect(m_variants, &QSpinBox::valueChanged, &m_refresh, qOverload<>(&QTimer::start));
    connect(m_step, &QSpinBox::valueChanged, this, &ContactSheetWindow::refreshLater);
    connect(m_state, &StateField::edited, this, &ContactSheetWindow::refreshLater);
    connect(m_variations, &QTreeWidget::itemChanged, this, &ContactSheetWindow::refreshLater);
    connect(m_shot, &QComboBox::currentIndexChanged, this, [this] {
        updateState();
        refreshLater();
    });
    connect(m_spread, &QSpinBox::valueChanged, this, [this] {
        if (!m_parents.empty()) refreshLater();
    });
}

void ContactSheetWindow::refreshLater() {
    m_isStale = true;
    m_refresh.start();
}

/// Shows what the settings say now.
void ContactSheetWindow::refresh() {
    if (!asset()) return;
    const auto wanted = static_cast<std::size_t>(m_variants->value());
    if (!m_isStale && !m_generator.isBusy() && wanted <= m_count) return showFirst(wanted);
    m_selected.clear();
    for (const QListWidgetItem* item : m_list->selectedItems()) m_selected.insert(item->data(kNumberRole).toUInt());
    regenerate();
}

void ContactSheetWindow::regenerate() {
    start(m_parents.empty() ? generateVariants(*asset(), recipe()) : crossoverVariants(m_parents, recipe()));
}

/// Removes the variants from the number `count` on.
void ContactSheetWindow::showFirst(std::size_t count) {
    std::erase_if(m_cells, [&](const SheetCell& cell) { return cell.entry.number >= count; });
    for (int row = m_list->count() - 1; row >= 0; --row) {
        if (m_list->item(row)->data(kNumberRole).toUInt() >= count) delete m_list->takeItem(row);
    }
    m_count = count;
    updateState();
}

QWidget* ContactSheetWindow::createSettings() {
    auto* settings = new QWidget;
    settings->setFixedWidth(kSettingsWidth);
    auto* form = new QFormLayout(settings);
    form->setContentsMargins(0, 0, 0, 0);
    setRange(*m_variants, ProjectNumber::Variants);
    m_variants->setValue(kDefaultVariants);
    form->addRow(tr("&Variants:"), m_variants);
    m_shot->setObjectName("sheet-shot");
    form->addRow(tr("Saved t&hrow:"), m_shot);
    m_state->setObjectName("sheet-state");
    m_state->setToolTip(tr("Set the scene, or the state beside the project, that variants start from"));
    form->addRow(tr("Star&t:"), m_state);
    setRange(*m_step, ProjectNumber::Step);
    m_step->setValue(kDefaultStep);
    m_step->setToolTip(tr("Set the simulation step at which variants are shown"));
    form->addRow(tr("S&tep:"), m_step);
    m_sort->setObjectName("sheet-sort");
    for (int k = 0; k < kSheetMeasures; ++k) m_sort->addItem(measureName(static_cast<SheetMeasure>(k)));
    form->addRow(tr("&Sort by:"), m_sort);
    m_spread->setRange(0, kMaxSpread);
    m_spread->setValue(kDefaultSpread);
    m_spread->setSuffix(tr(" %"));
    m_spread->setToolTip(tr("Set the largest change of parameters from parents to children"));
    form->addRow(tr("&Mutation:"), m_spread);
    form->addRow(m_variations);
    form->addRow(m_reseed);
    form->addRow(m_lock);
    return settings;
}

QWidget* ContactSheetWindow::createBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_summary->setObjectName("sheet-summary");
    m_summary->setTextFormat(Qt::PlainText);
    m_progress->setMaximumWidth(kProgressWidth);
    m_progress->setAccessibleName(tr("Generating variants"));
    row->addWidget(m_summary, 1);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_progress, m_cancel, m_crossOver, m_apply})
        row->addWidget(widget);
    return bar;
}

void ContactSheetWindow::fillShots() {
    const Id selected = m_shot->currentData().toUInt();
    const QSignalBlocker blocker(m_shot);
    m_shot->clear();
    m_shot->addItem(tr("None"), 0u);
    for (const Shot& shot : m_workspace.project().shots) m_shot->addItem(nameText(shot.name), shot.id);
    m_shot->setCurrentIndex(std::max(0, m_shot->findData(selected)));
}

/// Shows the document's asset, layers and shots; closes the window if the asset was deleted.
void ContactSheetWindow::updateDocument() {
    if (!asset()) return void(close());
    setWindowTitle(tr("Contact Sheet – %1").arg(nameText(asset()->name)));
    fillShots();
    const QSignalBlocker blocker(m_variations);
    m_variations->setAsset(*asset());
    updateState();
}

VariantRecipe ContactSheetWindow::recipe() const {
    return {.count = static_cast<std::uint32_t>(m_variants->value()),
            .randomSeed = m_randomSeed,
            .kinds = m_variations->kinds(),
            .varied = m_variations->varied(),
            .spread = m_spread->value() / 100.0,
            .locked = m_locked};
}

Result<std::optional<SheetStage>> ContactSheetWindow::stage() const {
    const Id shot = m_shot->currentData().toUInt();
    if (shot == 0) return std::optional<SheetStage>();
    SheetStage stage{.shots = {shot}, .step = static_cast<std::uint64_t>(m_step->value())};
    if (m_state->state().isEmpty()) return std::optional(std::move(stage));
    const QFileInfo file(QFileInfo(m_workspace.file().path()).dir(), m_state->state());
    Result<SavedSession> saved = loadSavedSession(toPath(file.filePath()), sceneHash(m_workspace.project()));
    if (!saved) return saved.error();
    stage.state = std::make_shared<const SavedSession>(std::move(*saved));
    return std::optional(std::move(stage));
}

const SheetEntry& ContactSheetWindow::entryOf(const QListWidgetItem& item) const {
    const auto number = item.data(kNumberRole).toUInt();
    return std::ranges::find(m_cells, number, [](const SheetCell& cell) { return cell.entry.number; })->entry;
}

void ContactSheetWindow::generate() {
    m_parents.clear();
    m_selected.clear();
    regenerate();
}

void ContactSheetWindow::crossOver() {
    std::vector<Asset> parents;
    for (const QListWidgetItem* item : m_list->selectedItems()) {
        if (!entryOf(*item).fault) parents.push_back(entryOf(*item).asset);
    }
    ++m_randomSeed;
    m_parents = std::move(parents);
    m_selected.clear();
    regenerate();
}

void ContactSheetWindow::start(Result<std::vector<Asset>> variants) {
    m_refresh.stop();
    m_isStale = false;
    if (!variants) return showMessage(QString::fromStdString(variants.error().message));
    Result<std::optional<SheetStage>> staged = stage();
    if (!staged) return showMessage(QString::fromStdString(staged.error().message));
    m_cells.clear();
    m_list->clear();
    m_count = variants->size();
    const Bakes& bakes = m_workspace.bakes();
    SheetRequest request{.project = m_workspace.project(),
                         .bakes = bakes.assetBakes(),
                         .asset = m_asset,
                         .variants = std::move(*variants),
                         .stage = std::move(*staged)};
    if (!bakes.areCurrent(request.project)) request.bakes.clear();
    const double ratio = devicePixelRatioF();
    const SheetStyle style{
        .size = {static_cast<int>(kPictureSize.width() * ratio), static_cast<int>(kPictureSize.height() * ratio)},
        .theme = themeOf(palette()),
        .view = request.stage ? StandardView::Isometric : StandardView::Front};
    m_generator.start(std::move(request), style);
}

void ContactSheetWindow::add(const SheetCell& cell) {
    m_cells.push_back(cell);
    auto* item =
        new QListWidgetItem(QIcon(pictureOf(cell, devicePixelRatioF())), captionOf(cell.entry, m_units), m_list);
    item->setData(kNumberRole, cell.entry.number);
    item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    item->setToolTip(toolTipText(item->text()));
    item->setSelected(m_selected.contains(cell.entry.number));
    sort();
    updateState();
}

/// Sorts the items by the measure, and keeps current and selected items.
void ContactSheetWindow::sort() {
    std::vector<SheetEntry> entries;
    for (const SheetCell& cell : m_cells) entries.push_back(cell.entry);
    std::ranges::sort(entries, {}, &SheetEntry::number);
    const std::vector<std::uint32_t> order = sortedBy(static_cast<SheetMeasure>(m_sort->currentIndex()), entries);
    std::map<std::uint32_t, QListWidgetItem*> items;
    const QListWidgetItem* current = m_list->currentItem();
    std::set<std::uint32_t> selected;
    for (const QListWidgetItem* item : m_list->selectedItems()) selected.insert(item->data(kNumberRole).toUInt());
    while (m_list->count() > 0) {
        QListWidgetItem* item = m_list->takeItem(0);
        items[item->data(kNumberRole).toUInt()] = item;
    }
    for (const std::uint32_t index : order) {
        QListWidgetItem* item = items.at(entries[index].number);
        m_list->addItem(item);
        if (item == current) m_list->setCurrentItem(item, QItemSelectionModel::NoUpdate);
        item->setSelected(selected.contains(entries[index].number));
    }
}

std::vector<std::uint32_t> ContactSheetWindow::shownNumbers() const {
    std::vector<std::uint32_t> numbers;
    for (int k = 0; k < m_list->count(); ++k) numbers.push_back(m_list->item(k)->data(kNumberRole).toUInt());
    return numbers;
}

void ContactSheetWindow::lockSelected() {
    const Selection& selection = m_workspace.selection();
    const auto baked = m_workspace.bakes().find(m_asset);
    const Selection::Seeds seeds = selection.fragments().seedsOf({});
    m_locked.clear();
    if (selection.asset() == m_asset && baked && baked->bake) {
        m_locked = lockedIn(*baked->bake, std::vector(seeds.begin(), seeds.end()));
    }
    const int count = static_cast<int>(m_locked.size());
    showMessage(count == 0 ? tr("No seeds are locked. Select seeds in the canvas to lock them.")
                           : tr("%Ln seed(s) locked in all new variants.", nullptr, count));
}

/// Asks what becomes of merges, splits and own settings of fragments, if the variant does not have them.
ContactSheetWindow::FragmentSettings ContactSheetWindow::askForSettings(const Asset& variant) {
    const Asset& own = *asset();
    const bool isSame = own.edits == variant.edits && own.fragmentLevels == variant.fragmentLevels &&
                        own.fragmentThresholds == variant.fragmentThresholds &&
                        own.bonding.neverBreaks == variant.bonding.neverBreaks &&
                        own.bonding.clusters == variant.bonding.clusters;
    const bool hasNone = own.edits.empty() && own.fragmentLevels.empty() && own.fragmentThresholds.empty() &&
                         own.bonding.neverBreaks.empty() && own.bonding.clusters.empty();
    if (isSame || hasNone) return FragmentSettings::OfVariant;
    Question question{.text = tr("Keep what was changed in single fragments of \"%1\"?").arg(nameText(own.name)),
                      .informativeText = fragmentChanges(own),
                      .answers = {{tr("Keep"), QMessageBox::AcceptRole},
                                  {tr("Remove"), QMessageBox::DestructiveRole},
                                  {tr("Cancel"), QMessageBox::RejectRole}}};
    constexpr FragmentSettings kAnswers[] = {FragmentSettings::OfAsset, FragmentSettings::OfVariant,
                                             FragmentSettings::Cancelled};
    return kAnswers[ask(this, question)];
}

void ContactSheetWindow::apply() {
    const QList<QListWidgetItem*> selected = m_list->selectedItems();
    if (selected.size() != 1 || !asset()) return;
    const Asset variant = entryOf(*selected.front()).asset;
    const FragmentSettings settings = askForSettings(variant);
    if (settings == FragmentSettings::Cancelled || !asset()) return;
    Asset changed = *asset();
    changed.pattern = variant.pattern;
    changed.levels = variant.levels;
    if (settings == FragmentSettings::OfVariant) {
        changed.fragmentLevels = variant.fragmentLevels;
        changed.edits = variant.edits;
        changed.fragmentThresholds = variant.fragmentThresholds;
        changed.bonding.neverBreaks = variant.bonding.neverBreaks;
        changed.bonding.clusters = variant.bonding.clusters;
    }
    const QScopedValueRollback applying(m_isApplying, true);  // the variants stay to be compared
    if (m_workspace.document().push(modify(tr("Apply Variant"), std::move(changed))))
        showMessage(tr("Applied the variant to the asset."));
}

void ContactSheetWindow::updateState() {
    const int count = static_cast<int>(m_cells.size()), selected = static_cast<int>(m_list->selectedItems().size());
    const bool isBusy = m_generator.isBusy();
    m_crossOver->setEnabled(selected > 0 && !isBusy);
    m_apply->setEnabled(selected == 1);
    m_progress->setVisible(isBusy);
    m_cancel->setVisible(isBusy);
    for (QWidget* field : {static_cast<QWidget*>(m_state), static_cast<QWidget*>(m_step)}) {
        field->setEnabled(m_shot->currentData().toUInt() != 0);
    }
    m_lock->setText(m_locked.empty() ? tr("&Lock Selected Seeds")
                                     : tr("&Lock Selected Seeds (%L1 locked)").arg(m_locked.size()));
    QString summary = isBusy ? tr("%L1 of %Ln variant(s)", nullptr, static_cast<int>(m_count)).arg(count)
                             : tr("%Ln variant(s)", nullptr, count);
    if (!isBusy && selected > 0) summary += tr(", %L1 selected").arg(selected);
    m_summary->setText(summary);
}

void ContactSheetWindow::showMessage(const QString& sentence) {
    updateState();
    m_summary->setText(sentence);
}

void ContactSheetWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    if (m_generator.isBusy()) return m_generator.cancel();
    close();
}

/// The pictures have the colours of the theme.
void ContactSheetWindow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_count > 0 && isVisible()) refreshLater();
    QWidget::changeEvent(event);
}

void ContactSheetWindow::closeEvent(QCloseEvent* event) {
    m_refresh.stop();
    m_generator.cancel();
    event->accept();
}

}  // namespace rubble

#include "moc_ContactSheetWindow.cpp"
