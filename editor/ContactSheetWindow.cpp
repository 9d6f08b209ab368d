#include "editor/ContactSheetWindow.h"

#include "editor/MainWindow.h"
#include "editor/SheetVariety.h"
#include "editor/SheetWords.h"
#include "editor/Theme.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/icons/Icon.h"

#include <QCloseEvent>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QScreen>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <map>
#include <set>

namespace rubble {

namespace {

constexpr QSize kPicture{240, 180};
constexpr QSize kFirstSize{1180, 760};
constexpr double kScreenShare = 0.9;  // that it takes at most at first
constexpr int kSettingsWidth = 300;
constexpr int kUsualVariants = 12;
constexpr int kMostSteps = 100'000;
constexpr int kUsualStep = 60;    // a second after the start
constexpr int kUsualSpread = 15;  // per cent
constexpr int kNumber = Qt::UserRole;

QPushButton* button(const char* icon, const QString& text, const QString& tip) {
    auto* made = new QPushButton(iconNamed(icon), text);
    made->setToolTip(tip);
    made->setAutoDefault(false);
    return made;
}

/// What stands in a list while there is no picture: a plate with a sentence's sign.
QPixmap plateFor(const SheetCell& cell, double ratio) {
    if (!cell.picture.isNull()) {
        QPixmap pixmap = QPixmap::fromImage(cell.picture);
        pixmap.setDevicePixelRatio(ratio);
        return pixmap;
    }
    return iconNamed("message-error").pixmap(kPicture / 3, ratio);
}

}  // namespace

ContactSheetWindow::ContactSheetWindow(MainWindow& window)
    : QWidget(&window, Qt::Window),
      m_window(window),
      m_asset(window.workspace().selection().asset()),
      m_variety(new SheetVariety),
      m_variants(new QSpinBox),
      m_spread(new QSpinBox),
      m_shot(new QComboBox),
      m_step(new QSpinBox),
      m_sort(new QComboBox),
      m_list(new QListWidget),
      m_summary(new QLabel),
      m_progress(new QProgressBar),
      m_make(button("dice", tr("&Make Others"), tr("Make variants of the asset as it is, by other random seeds"))),
      m_lock(
          button("sheet-lock", tr("&Lock Chosen Seeds"),
                 tr("Hold the seeds that are chosen in the canvas where they are, in all that is made from now on"))),
      m_breed(button("sheet-breed", tr("&Breed"), tr("Make children of the chosen variants"))),
      m_use(button("sheet-use", tr("&Use"), tr("Take the pattern of the chosen variant for the asset"))),
      m_cancel(button("remove", tr("&Cancel"), tr("Stop making variants; those that are there stay"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("contact-sheet");
    resize(kFirstSize.boundedTo(window.screen()->availableSize() * kScreenShare));
    auto* columns = new QHBoxLayout(this);
    columns->addWidget(makeSettings());
    auto* rows = new QVBoxLayout;
    rows->addWidget(m_list, 1);
    rows->addWidget(makeBar());
    columns->addLayout(rows, 1);
    m_list->setViewMode(QListView::IconMode);
    m_list->setResizeMode(QListView::Adjust);
    m_list->setMovement(QListView::Static);
    m_list->setIconSize(kPicture);
    m_list->setSpacing(8);
    m_list->setUniformItemSizes(false);
    m_list->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_list->setWordWrap(true);
    m_list->setAccessibleName(tr("Variants"));
    m_list->setObjectName("sheet-list");
    connect(m_list, &QListWidget::itemActivated, this, &ContactSheetWindow::use);
    connect(m_list, &QListWidget::itemSelectionChanged, this, &ContactSheetWindow::update);
    connect(&m_maker, &SheetMaker::made, this, &ContactSheetWindow::add);
    connect(&m_maker, &SheetMaker::changed, this, &ContactSheetWindow::update);
    connect(&m_maker, &SheetMaker::failed, this, &ContactSheetWindow::say);
    connect(&m_maker, &SheetMaker::progressed, this,
            [this](double fraction) { m_progress->setValue(static_cast<int>(100.0 * fraction)); });
    connect(&window.workspace().document(), &Document::changed, this, &ContactSheetWindow::takeDocument);
    takeDocument();
    m_list->setFocus();
}

const Asset* ContactSheetWindow::asset() const { return findAsset(m_window.workspace().project(), m_asset); }

QWidget* ContactSheetWindow::makeSettings() {
    auto* settings = new QWidget;
    settings->setFixedWidth(kSettingsWidth);
    auto* form = new QFormLayout(settings);
    form->setContentsMargins(0, 0, 0, 0);
    m_variants->setRange(1, static_cast<int>(BreedingRecipe::kMostVariants));
    m_variants->setValue(kUsualVariants);
    form->addRow(tr("&Variants:"), m_variants);
    m_shot->setObjectName("sheet-shot");
    form->addRow(tr("S&hot:"), m_shot);
    m_step->setRange(0, kMostSteps);
    m_step->setValue(kUsualStep);
    m_step->setSuffix(tr(" steps after the start"));
    form->addRow(tr("&At:"), m_step);
    m_sort->setObjectName("sheet-sort");
    for (int k = 0; k < kSheetMeasures; ++k) m_sort->addItem(nameText(static_cast<SheetMeasure>(k)));
    form->addRow(tr("&Sort by:"), m_sort);
    m_spread->setRange(0, 90);
    m_spread->setValue(kUsualSpread);
    m_spread->setSuffix(tr(" %"));
    m_spread->setToolTip(tr("By how much the numbers of children differ from their parents', at most"));
    form->addRow(tr("S&pread:"), m_spread);
    form->addRow(m_variety);
    form->addRow(m_make);
    form->addRow(m_lock);
    connect(m_sort, &QComboBox::currentIndexChanged, this, &ContactSheetWindow::sort);
    connect(m_shot, &QComboBox::currentIndexChanged, this, &ContactSheetWindow::update);
    connect(m_make, &QPushButton::clicked, this, [this] {
        ++m_randomSeed;
        make();
    });
    connect(m_lock, &QPushButton::clicked, this, &ContactSheetWindow::lockChosen);
    return settings;
}

QWidget* ContactSheetWindow::makeBar() {
    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    m_summary->setObjectName("sheet-summary");
    m_progress->setMaximumWidth(160);
    m_progress->setAccessibleName(tr("Making variants"));
    row->addWidget(m_summary, 1);
    for (QWidget* widget : std::initializer_list<QWidget*>{m_progress, m_cancel, m_breed, m_use})
        row->addWidget(widget);
    connect(m_cancel, &QPushButton::clicked, &m_maker, &SheetMaker::cancel);
    connect(m_breed, &QPushButton::clicked, this, &ContactSheetWindow::breed);
    connect(m_use, &QPushButton::clicked, this, &ContactSheetWindow::use);
    return bar;
}

void ContactSheetWindow::fillShots() {
    const Id chosen = m_shot->currentData().toUInt();
    const QSignalBlocker quiet(m_shot);
    m_shot->clear();
    m_shot->addItem(tr("None: pieces at rest"), 0u);
    for (const Shot& shot : m_window.workspace().project().shots) {
        m_shot->addItem(QString::fromStdString(shot.name), shot.id);
    }
    m_shot->setCurrentIndex(std::max(0, m_shot->findData(chosen)));
}

/// The asset, its layers and the shots as they are now; without the asset there is nothing left to show.
void ContactSheetWindow::takeDocument() {
    const Asset* at = asset();
    if (!at) return void(close());
    setWindowTitle(tr("Contact Sheet – %1").arg(QString::fromStdString(at->name)));
    fillShots();
    m_variety->setAsset(*at);
    update();
}

BreedingRecipe ContactSheetWindow::recipe() const {
    return {.count = static_cast<std::uint32_t>(m_variants->value()),
            .randomSeed = m_randomSeed,
            .kinds = m_variety->kinds(),
            .varied = m_variety->varied(),
            .spread = m_spread->value() / 100.0,
            .locked = m_locked};
}

std::optional<SheetStage> ContactSheetWindow::stage() const {
    const Id shot = m_shot->currentData().toUInt();
    if (shot == 0) return std::nullopt;
    return SheetStage{.shots = {shot}, .step = static_cast<std::uint64_t>(m_step->value())};
}

void ContactSheetWindow::make() { begin(variantsOf(*asset(), recipe())); }

void ContactSheetWindow::breed() {
    std::vector<Asset> parents;
    for (const QListWidgetItem* item : m_list->selectedItems()) {
        const auto number = item->data(kNumber).toUInt();
        const auto cell = std::ranges::find(m_cells, number, [](const SheetCell& one) { return one.entry.number; });
        if (!cell->entry.fault) parents.push_back(cell->entry.asset);
    }
    ++m_randomSeed;
    begin(childrenOf(parents, recipe()));
}

void ContactSheetWindow::begin(Result<std::vector<Asset>> variants) {
    if (!variants) return say(QString::fromStdString(variants.error().message));
    m_cells.clear();
    m_list->clear();
    m_count = variants->size();
    Workspace& workspace = m_window.workspace();
    SheetOrder order{.project = workspace.project(),
                     .bakes = workspace.bakes().assetBakes(),
                     .asset = m_asset,
                     .variants = {},
                     .stage = stage()};
    if (!workspace.bakes().areCurrent(order.project)) order.bakes.clear();
    order.variants = std::move(*variants);
    const double ratio = devicePixelRatioF();
    const SheetLook look{
        .size = {static_cast<int>(kPicture.width() * ratio), static_cast<int>(kPicture.height() * ratio)},
        .theme = isDark(palette()) ? Theme::Dark : Theme::Light,
        .view = order.stage ? StandardView::Isometric : StandardView::Front};
    m_maker.make(std::move(order), look);
}

void ContactSheetWindow::add(const SheetCell& cell) {
    m_cells.push_back(cell);
    auto* item = new QListWidgetItem(QIcon(plateFor(cell, devicePixelRatioF())), labelText(cell.entry), m_list);
    item->setData(kNumber, cell.entry.number);
    item->setTextAlignment(Qt::AlignHCenter | Qt::AlignTop);
    item->setToolTip(item->text());
    sort();
    update();
}

/// Puts the rows into the order of the measure; what is chosen stays so.
void ContactSheetWindow::sort() {
    std::vector<SheetEntry> entries;
    for (const SheetCell& cell : m_cells) entries.push_back(cell.entry);
    std::ranges::sort(entries, {}, &SheetEntry::number);
    const std::vector<std::uint32_t> order = sortedBy(static_cast<SheetMeasure>(m_sort->currentIndex()), entries);
    std::map<std::uint32_t, QListWidgetItem*> items;
    const QListWidgetItem* current = m_list->currentItem();
    std::set<std::uint32_t> chosen;
    for (const QListWidgetItem* item : m_list->selectedItems()) chosen.insert(item->data(kNumber).toUInt());
    while (m_list->count() > 0) {
        QListWidgetItem* item = m_list->takeItem(0);
        items[item->data(kNumber).toUInt()] = item;
    }
    for (const std::uint32_t place : order) {
        QListWidgetItem* item = items.at(entries[place].number);
        m_list->addItem(item);
        if (item == current) m_list->setCurrentItem(item, QItemSelectionModel::NoUpdate);
        item->setSelected(chosen.contains(entries[place].number));
    }
}

std::vector<std::uint32_t> ContactSheetWindow::shownNumbers() const {
    std::vector<std::uint32_t> numbers;
    for (int k = 0; k < m_list->count(); ++k) numbers.push_back(m_list->item(k)->data(kNumber).toUInt());
    return numbers;
}

void ContactSheetWindow::lockChosen() {
    Workspace& at = m_window.workspace();
    const auto baked = at.bakes().find(m_asset);
    const bool isOfAsset = at.selection().asset() == m_asset && baked && baked->bake;
    const Selection::Seeds seeds = at.selection().choice().seedsInside({});
    m_locked.clear();
    if (isOfAsset) m_locked = lockedIn(*baked->bake, std::vector(seeds.begin(), seeds.end()));
    say(m_locked.empty() ? tr("No seed is locked. Choose some in the canvas to lock them.")
                         : tr("%L1 seeds stay where they are in all that is made from now on.").arg(m_locked.size()));
}

void ContactSheetWindow::use() {
    const QList<QListWidgetItem*> chosen = m_list->selectedItems();
    if (chosen.size() != 1 || !asset()) return;
    const auto number = chosen.front()->data(kNumber).toUInt();
    const auto cell = std::ranges::find(m_cells, number, [](const SheetCell& one) { return one.entry.number; });
    Asset changed = *asset();
    changed.pattern = cell->entry.asset.pattern;
    changed.levels = cell->entry.asset.levels;
    changed.leaves = cell->entry.asset.leaves;
    changed.edits = cell->entry.asset.edits;
    m_window.workspace().document().push(altered(tr("Use variant"), std::move(changed)));
    say(tr("Taken for the asset; undo takes it back."));
}

void ContactSheetWindow::update() {
    const qsizetype chosen = m_list->selectedItems().size();
    const bool isBusy = m_maker.isBusy();
    m_breed->setEnabled(chosen > 0 && !isBusy);
    m_use->setEnabled(chosen == 1);
    m_progress->setVisible(isBusy);
    m_cancel->setVisible(isBusy);
    m_step->setEnabled(m_shot->currentData().toUInt() != 0);
    m_lock->setText(m_locked.empty() ? tr("&Lock Chosen Seeds")
                                     : tr("&Lock Chosen Seeds (%L1 locked)").arg(m_locked.size()));
    m_summary->setText(isBusy       ? tr("%L1 of %L2 variants").arg(m_cells.size()).arg(m_count)
                       : chosen > 0 ? tr("%L1 variants, %L2 chosen").arg(m_cells.size()).arg(chosen)
                                    : tr("%L1 variants").arg(m_cells.size()));
}

void ContactSheetWindow::say(const QString& sentence) {
    update();
    m_summary->setText(sentence);
}

void ContactSheetWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape) return QWidget::keyPressEvent(event);
    if (m_maker.isBusy()) return m_maker.cancel();
    close();
}

void ContactSheetWindow::closeEvent(QCloseEvent* event) {
    m_maker.cancel();
    event->accept();
}

}  // namespace rubble
