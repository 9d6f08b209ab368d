#include "editor/panels/docks/FragmentTable.h"

#include "core/base/Parallel.h"
#include "editor/background/ProblemWatch.h"
#include "editor/document/FragmentVisibility.h"
#include "editor/panels/docks/VolumeHistogram.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Buttons.h"
#include "editor/widgets/Icon.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSplitter>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kRowMargin = 6;   // pixels that a row is higher than its text
constexpr int kCellMargin = 8;  // pixels that a column is wider than its text

/// A flag per row: the view selects it.
std::vector<bool> selectedRows(const QTableView& view) {
    std::vector<bool> isSelected(static_cast<std::size_t>(view.model()->rowCount()), false);
    for (const QItemSelectionRange& range : view.selectionModel()->selection()) {
        std::fill(isSelected.begin() + range.top(), isSelected.begin() + range.bottom() + 1, true);
    }
    return isSelected;
}

/// The fewest ranges that cover the marked rows.
QItemSelection rowRanges(const std::vector<bool>& isMarked, const QAbstractItemModel& model) {
    QItemSelection ranges;
    const int count = static_cast<int>(isMarked.size()), lastColumn = model.columnCount() - 1;
    for (int row = 0; row < count; ++row) {
        if (!isMarked[static_cast<std::size_t>(row)]) continue;
        const int first = row;
        while (row + 1 < count && isMarked[static_cast<std::size_t>(row) + 1]) ++row;
        ranges.append(QItemSelectionRange(model.index(first, 0), model.index(row, lastColumn)));
    }
    return ranges;
}

}  // namespace

FragmentTable::FragmentTable(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_selection(selection),
      m_bakes(bakes),
      m_model(new FragmentModel(this)),
      m_listed(new FragmentProxyModel(*m_model, this)),
      m_view(new QTableView(this)),
      m_histogram(new VolumeHistogram(this)),
      m_filter(new QLineEdit(this)),
      m_buttons(new QHBoxLayout),
      m_totals(new QLabel(this)) {
    buildView();
    buildFilter();
    buildActions();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto* head = new QHBoxLayout;
    head->setContentsMargins(4, 2, 4, 2);
    head->setSpacing(2);
    head->addWidget(m_filter, 1);
    head->addLayout(m_buttons);
    m_buttons->setSpacing(2);
    m_buttons->addWidget(panelButton(m_invert, this));
    layout->addLayout(head);
    auto* parts = new QSplitter(Qt::Horizontal);
    parts->addWidget(m_view);
    parts->addWidget(m_histogram);
    parts->setStretchFactor(0, 1);
    parts->setStretchFactor(1, 0);
    layout->addWidget(parts, 1);
    m_totals->setContentsMargins(6, 3, 6, 3);
    m_totals->setWordWrap(true);
    m_totals->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_totals->setToolTip(tr("Number, volume and mass of the listed and the selected fragments"));
    m_totals->setAccessibleName(tr("Totals"));
    layout->addWidget(m_totals);
    setFocusProxy(m_view);
    connectAll();
    updateState();
}

void FragmentTable::buildView() {
    m_view->setModel(m_listed);
    m_view->setFrameShape(QFrame::NoFrame);
    m_view->setShowGrid(false);
    m_view->setAlternatingRowColors(true);
    m_view->setWordWrap(false);
    m_view->setTabKeyNavigation(false);
    m_view->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_view->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_view->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    m_view->setAccessibleName(tr("Fragments"));
    m_view->setAccessibleDescription(tr("The fragments of the active asset with their metrics"));
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowMargin);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->sortByColumn(0, Qt::AscendingOrder);
    m_view->setSortingEnabled(true);
    for (int column = 1; column < kFragmentColumns; ++column) m_view->setColumnWidth(column, 0);
    widenColumns();
}

void FragmentTable::buildFilter() {
    addClearButton(*m_filter);
    m_filter->setPlaceholderText(tr("Filter, for example: neighbours >= 5"));
    m_filter->setToolTip(tr("List only fragments that match all words and conditions, such as mass < 2 kg"));
    m_filter->setStatusTip(m_filter->toolTip());
    m_filter->setAccessibleName(tr("Filter Fragments"));
    if (const QIcon icon = iconNamed("filter"); !icon.isNull())
        m_filter->addAction(icon, QLineEdit::LeadingPosition)->setText(tr("Filter"));
}

/// Creates the actions that only the table has. Their names differ from those in the menus, whose icons they share.
void FragmentTable::buildActions() {
    m_show = makeAction(this, {"show", tr("Sho&w Fragments"), tr("Show the selected fragments")});
    m_show->setObjectName("table-show");
    connect(m_show, &QAction::triggered, this, &FragmentTable::showSelected);
    m_invert = makeAction(this, {"select-invert", tr("&Invert Selection"),
                                 tr("Invert the selection among the listed fragments"), QKeySequence("Ctrl+Shift+I")});
    m_invert->setObjectName("table-invert");
    m_invert->setShortcutContext(Qt::WidgetShortcut);
    connect(m_invert, &QAction::triggered, this, &FragmentTable::invertSelection);
    m_frame = makeAction(this, {"view-frame", tr("&Frame Selected"), tr("Frame the selected fragments"), Qt::Key_F});
    m_frame->setObjectName("table-frame");
    m_frame->setShortcutContext(Qt::WidgetShortcut);
    connect(m_frame, &QAction::triggered, this, &FragmentTable::frameRequested);
    m_view->installEventFilter(this);
}

void FragmentTable::setFragmentActions(const QList<QAction*>& visibility, const QList<QAction*>& others) {
    m_visibilityActions = visibility;
    m_fragmentActions = others;
    for (int k = 0; k < visibility.size(); ++k) m_buttons->insertWidget(k, panelButton(visibility[k], this));
}

void FragmentTable::connectAll() {
    connect(m_histogram, &VolumeHistogram::rangeSelected, this, &FragmentTable::selectRange);
    connect(m_filter, &QLineEdit::textChanged, this, &FragmentTable::applyFilter);
    connect(m_view, &QTableView::doubleClicked, this, &FragmentTable::frameRequested);
    connect(m_view, &QTableView::customContextMenuRequested, this, &FragmentTable::showMenu);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { applyViewSelection(); });
    connect(m_listed, &FragmentProxyModel::modelAboutToBeReset, this, &FragmentTable::saveScrollPosition);
    connect(m_listed, &FragmentProxyModel::modelReset, this, &FragmentTable::restoreScrollPosition);
    connect(&m_document, &Document::changed, this, &FragmentTable::refreshDensity);
    connect(&m_selection, &Selection::assetChanged, this, &FragmentTable::refreshAsset);
    connect(&m_selection, &Selection::seedsChanged, this, &FragmentTable::showSelection);
    connect(&m_selection, &Selection::hiddenChanged, this, [this] {
        m_model->setHidden(m_selection.hidden());
        updateState();
    });
    connect(&m_bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) bakeChanged();
    });
}

/// Widens columns to their headers and four digits; never narrows what the user widened.
void FragmentTable::widenColumns() {
    QHeaderView* header = m_view->horizontalHeader();
    const int least = fontMetrics().horizontalAdvance(QStringLiteral("0.0001234"));
    for (int column = 0; column < kFragmentColumns; ++column) {
        const bool isLong = FragmentColumn(column) < FragmentColumn::Aspect;
        const int width = std::max(isLong ? least : 0, header->sectionSizeHint(column)) + kCellMargin;
        if (header->sectionSize(column) < width) header->resizeSection(column, width);
    }
}

void FragmentTable::setUnits(const Units& units) {
    if (units == m_units) return;
    m_units = units;
    m_model->setUnits(units);
    m_histogram->setUnits(units);
    widenColumns();
    applyFilter();
}

void FragmentTable::showMenu(const QPoint& position) {
    QMenu menu;
    menu.setToolTipsVisible(true);
    menu.addActions(m_visibilityActions);
    menu.addAction(m_show);
    menu.addSeparator();
    menu.addAction(m_invert);
    menu.addAction(m_frame);
    menu.addSeparator();
    menu.addActions(m_fragmentActions);
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

/// Handles the table's shortcuts before those of the window and the keys of the menu bar.
bool FragmentTable::eventFilter(QObject* watched, QEvent* event) {
    return handleShortcut(m_visibilityActions + QList{m_frame, m_invert}, *event) ||
           QWidget::eventFilter(watched, event);
}

void FragmentTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_isStale) refreshBake();
}

void FragmentTable::refreshAsset() {
    bakeChanged();
    m_view->scrollToTop();
}

void FragmentTable::bakeChanged() {
    m_isStale = true;
    if (isVisible()) refreshBake();
}

void FragmentTable::refreshBake() {
    m_isStale = false;
    const std::shared_ptr<const BakedAsset> baked = m_bakes.find(m_selection.asset());
    const bool hasBake = baked && baked->bake;
    m_model->setMetrics(hasBake ? FragmentMetrics(baked->bake, density(), availableProcessors()) : FragmentMetrics());
    refreshProblems();
}

void FragmentTable::setProblems(const ProblemWatch& watch) {
    m_watch = &watch;
    connect(&watch, &ProblemWatch::changed, this, &FragmentTable::refreshProblems);
    refreshProblems();
}

/// Problems are found some time after the bake.
void FragmentTable::refreshProblems() {
    const bool isOfBake = m_watch && m_watch->bakeOf(m_selection.asset()) == m_model->metrics().bake();
    if (isOfBake && m_model->metrics().bake()) m_model->setProblems(m_watch->of(m_selection.asset()));
}

/// Selects the listed fragments of these volumes.
void FragmentTable::selectRange(double min, double max, bool isExtending) {
    const std::shared_ptr<const Bake>& bake = m_model->metrics().bake();
    if (!bake) return;
    FragmentSet selected = fragmentsOfVolume(*bake, min, max);
    const FragmentSet shown = m_listed->listedFragments(), before = m_model->fragmentsOf(m_selection.fragments());
    for (std::size_t k = 0; k < selected.size(); ++k) {
        selected[k] = (selected[k] && shown[k]) || (isExtending && before[k]);
    }
    m_selection.setFragments(selectionOf(selected, *bake, m_selection.enteredFragment()));
}

/// Shows the volumes of the listed leaf fragments: their parents' volumes would count twice.
void FragmentTable::updateHistogram() {
    std::vector<double> volumes;
    std::vector<bool> isSelected;
    if (const std::shared_ptr<const Bake>& bake = m_model->metrics().bake()) {
        const FragmentSet smallest = leafFragments(*bake), shown = m_listed->listedFragments();
        const FragmentSet selected = withDescendants(*bake, m_model->fragmentsOf(m_selection.fragments()));
        for (std::uint32_t k = 0; k < smallest.size(); ++k) {
            if (!smallest[k] || !shown[k]) continue;
            volumes.push_back(m_model->metrics().value(FragmentColumn::Volume, k));
            isSelected.push_back(selected[k]);
        }
    }
    m_histogram->setVolumes(std::move(volumes), std::move(isSelected));
}

double FragmentTable::density() const {
    const Material* material = asset() ? findMaterial(m_document.project(), asset()->material) : nullptr;
    return material ? material->density : 0.0;
}

void FragmentTable::refreshDensity(const Changes& changes) {
    const bool isOfMass = changes.touches(Part::Material) || changes.touches(Part::Asset, m_selection.asset());
    if (isOfMass) m_model->setDensity(density());
}

void FragmentTable::applyFilter() {
    Result<FragmentFilter> filter = fragmentFilter(m_filter->text(), m_units, locale());
    m_filterFault = filter ? QString() : QString::fromStdString(filter.error().message);
    if (filter) m_listed->setFilter(std::move(*filter));
    updateState();
}

void FragmentTable::saveScrollPosition() {
    m_savedRow = m_view->currentIndex().row();
    m_savedScroll = m_view->verticalScrollBar()->value();
}

void FragmentTable::restoreScrollPosition() {
    m_view->doItemsLayout();  // now, since the scroll bar still has the range of the old rows
    if (m_savedRow >= 0 && m_listed->rowCount() > 0) {
        const QModelIndex current = m_listed->index(std::min(m_savedRow, m_listed->rowCount() - 1), 0);
        m_view->selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
    }
    m_view->verticalScrollBar()->setValue(m_savedScroll);
    selectRows();
    updateState();
}

void FragmentTable::applyViewSelection() {
    if (m_isShowing || !m_model->metrics().bake()) return;
    const std::vector<bool> isSelected = selectedRows(*m_view);
    FragmentSet selected(m_model->metrics().count(), false);
    for (int row = 0; row < m_listed->rowCount(); ++row) {
        if (isSelected[static_cast<std::size_t>(row)]) selected[m_listed->fragmentAt(row)] = true;
    }
    const QScopedValueRollback applying(m_isApplying, true);
    m_selection.setFragments(selectionOf(selected, *m_model->metrics().bake(), m_selection.enteredFragment()));
    updateState();
}

void FragmentTable::showSelection() {
    if (m_isApplying) return;
    selectRows();
    scrollToSelection();
    updateState();
}

/// Selects the rows of the selected fragments, unless they are selected already.
void FragmentTable::selectRows() {
    const FragmentSet isSelected = m_model->fragmentsOf(m_selection.fragments());
    std::vector<bool> isWanted;
    for (int row = 0; row < m_listed->rowCount(); ++row) isWanted.push_back(isSelected[m_listed->fragmentAt(row)]);
    if (isWanted == selectedRows(*m_view)) return;
    const QScopedValueRollback showing(m_isShowing, true);
    QItemSelectionModel& rows = *m_view->selectionModel();
    rows.clearSelection();  // first, since select() compares two long lists of ranges in O(n²)
    rows.select(rowRanges(isWanted, *m_listed), QItemSelectionModel::Select);
    rows.select(QItemSelection(), QItemSelectionModel::Select);  // a new current range, which the mouse extends
}

/// Scrolls to the first selected row unless one is visible.
void FragmentTable::scrollToSelection() {
    const std::vector<bool> isSelected = selectedRows(*m_view);
    const auto first = std::ranges::find(isSelected, true);
    if (first == isSelected.end()) return;
    const int top = std::max(0, m_view->rowAt(0)), bottom = m_view->rowAt(m_view->viewport()->height() - 1);
    const auto end = bottom < 0 ? isSelected.end() : isSelected.begin() + bottom + 1;
    if (std::find(isSelected.begin() + top, end, true) != end) return;
    m_view->scrollTo(m_listed->index(static_cast<int>(first - isSelected.begin()), 0));
}

void FragmentTable::showSelected() {
    if (const Bake* bake = currentBake()) rubble::showSelected(m_selection, *bake);
}

void FragmentTable::invertSelection() {
    const Bake* bake = currentBake();
    if (!bake) return;
    FragmentSet rest = m_listed->listedFragments();
    const FragmentSet selected = m_model->fragmentsOf(m_selection.fragments());
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = rest[k] && !selected[k];
    m_selection.setFragments(selectionOf(rest, *bake, m_selection.enteredFragment()));
}

/// The bake of the rows; null if there is none.
const Bake* FragmentTable::currentBake() {
    if (m_isStale) refreshBake();
    return m_model->metrics().bake().get();
}

void FragmentTable::updateState() {
    const FragmentSelection &selected = m_selection.fragments(), &hidden = m_selection.hidden();
    m_show->setEnabled(std::ranges::any_of(selected.seeds, [&](SeedId seed) { return hidden.seeds.contains(seed); }));
    m_invert->setEnabled(m_listed->rowCount() > 0);
    m_totals->setText(totals());
    updateHistogram();
}

QString FragmentTable::totals() const {
    if (!m_filterFault.isEmpty()) return m_filterFault;
    if (!asset()) return tr("No asset selected");
    const std::shared_ptr<const BakedAsset> baked = m_bakes.find(m_selection.asset());
    if (!baked) return tr("Baking…");
    if (!baked->bake) return QString::fromStdString(baked->fault->message);
    const FragmentSum shown = m_model->metrics().sum(m_listed->listedFragments());
    const FragmentSum selected = m_model->metrics().sum(m_model->fragmentsOf(m_selection.fragments()));
    const QString count = locale().toString(m_model->metrics().count());
    const QString listed = tr("Listed: %1 of %2").arg(locale().toString(shown.count), count) + sumText(shown);
    if (selected.count == 0) return listed;
    return tr("%1 · Selected: %2").arg(listed, locale().toString(selected.count)) + sumText(selected);
}

/// ", 0.25 m³, 250 kg"
QString FragmentTable::sumText(const FragmentSum& sum) const {
    if (sum.count == 0) return {};
    return tr(", %1, %2")
        .arg(localizedQuantity(QuantityKind::Volume, sum.volume, m_units, locale()),
             localizedQuantity(QuantityKind::Mass, sum.mass, m_units, locale()));
}

}  // namespace rubble

#include "moc_FragmentTable.cpp"
