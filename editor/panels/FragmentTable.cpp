#include "editor/panels/FragmentTable.h"

#include "editor/document/FragmentHiding.h"
#include "editor/document/ProblemWatch.h"
#include "editor/panels/Icons.h"
#include "editor/panels/LocalNumber.h"
#include "editor/panels/VolumeHistogram.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QSplitter>
#include <QTableView>
#include <QThread>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rubble {

namespace {

constexpr int kRowMargin = 6;   // pixels that a row is higher than its text
constexpr int kCellMargin = 8;  // pixels that a column is wider than its text
constexpr int kSumDigits = 5;   // that are shown of sums

/// One mark a row: it is selected in the view.
std::vector<bool> selectedRows(const QTableView& view) {
    std::vector<bool> isSelected(static_cast<std::size_t>(view.model()->rowCount()), false);
    for (const QItemSelectionRange& range : view.selectionModel()->selection()) {
        std::fill(isSelected.begin() + range.top(), isSelected.begin() + range.bottom() + 1, true);
    }
    return isSelected;
}

/// The marked rows in as few ranges as can be.
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
      m_view(new QTableView(this)),
      m_histogram(new VolumeHistogram(this)),
      m_filter(new QLineEdit(this)),
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
    addButtons(*head);
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
    m_totals->setToolTip(tr("A piece of a fragment that is counted already adds no volume and no mass"));
    m_totals->setAccessibleName(tr("Totals of the fragments"));
    layout->addWidget(m_totals);
    setFocusProxy(m_view);
    connectAll();
    updateState();
}

void FragmentTable::buildView() {
    m_view->setModel(m_model);
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
    m_view->setAccessibleDescription(tr("The fragments of the asset at hand with their figures."));
    m_view->verticalHeader()->hide();
    m_view->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    m_view->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowMargin);
    m_view->horizontalHeader()->setHighlightSections(false);
    m_view->sortByColumn(0, Qt::AscendingOrder);
    m_view->setSortingEnabled(true);
    m_view->installEventFilter(this);
    for (int column = 1; column < kFragmentColumns; ++column) m_view->setColumnWidth(column, 0);
    widenColumns();
}

void FragmentTable::buildFilter() {
    m_filter->setClearButtonEnabled(true);
    m_filter->setPlaceholderText(tr("Filter, such as neighbours >= 5"));
    m_filter->setToolTip(
        tr("Parts of names, and conditions such as neighbours >= 5 or mass < 2 kg; all of them must hold"));
    m_filter->setStatusTip(m_filter->toolTip());
    m_filter->setAccessibleName(tr("Filter of the fragments"));
    if (const QIcon icon = iconNamed("filter"); !icon.isNull()) m_filter->addAction(icon, QLineEdit::LeadingPosition);
}

/// Keys are seen to by eventFilter(), so that they mean this table only while it has the focus.
QAction* FragmentTable::newAction(const QString& icon, const QString& text, const QString& hint,
                                  const QKeySequence& key, Deed deed) {
    auto* action = new QAction(iconNamed(icon), text, this);
    action->setShortcut(key);
    action->setShortcutContext(Qt::WidgetShortcut);
    action->setShortcutVisibleInContextMenu(true);
    const QString keyText = key.toString(QKeySequence::NativeText);
    action->setToolTip(keyText.isEmpty() ? hint : tr("%1 (%2)").arg(hint, keyText));
    action->setStatusTip(hint);
    connect(action, &QAction::triggered, this, deed);
    return action;
}

void FragmentTable::buildActions() {
    m_hide = newAction("hide", tr("Hide"), tr("Hide the chosen fragments, and let go of them"), QKeySequence(Qt::Key_H),
                       &FragmentTable::hideChosen);
    m_show = newAction("show", tr("Show"), tr("Show the chosen fragments again"), {}, &FragmentTable::showChosen);
    m_showAll = newAction("show", tr("Show all"), tr("Show all hidden fragments again"),
                          QKeySequence(Qt::ALT | Qt::Key_H), &FragmentTable::showAll);
    m_isolate = newAction("isolate", tr("Isolate"), tr("Hide all but the chosen fragments"),
                          QKeySequence(Qt::SHIFT | Qt::Key_H), &FragmentTable::isolateChosen);
    m_invert = newAction("select-invert", tr("Invert choice"),
                         tr("Choose the listed fragments that are not chosen, and let go of the others"),
                         QKeySequence(Qt::CTRL | Qt::Key_I), &FragmentTable::invertChoice);
}

void FragmentTable::addButtons(QBoxLayout& row) {
    for (QAction* action : {m_hide, m_showAll, m_isolate, m_invert}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        button->setAccessibleName(action->text());
        row.addWidget(button);
    }
}

void FragmentTable::connectAll() {
    connect(m_histogram, &VolumeHistogram::ranged, this, &FragmentTable::takeRange);
    connect(m_filter, &QLineEdit::textChanged, this, &FragmentTable::takeFilter);
    connect(m_view, &QTableView::customContextMenuRequested, this, &FragmentTable::showMenu);
    connect(m_view->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] { takeFromView(); });
    connect(m_model, &FragmentModel::modelAboutToBeReset, this, &FragmentTable::keepPlace);
    connect(m_model, &FragmentModel::modelReset, this, &FragmentTable::restorePlace);
    connect(&m_document, &Document::changed, this, &FragmentTable::takeChanges);
    connect(&m_selection, &Selection::assetChanged, this, &FragmentTable::takeAsset);
    connect(&m_selection, &Selection::seedsChanged, this, &FragmentTable::showSelection);
    connect(&m_selection, &Selection::hiddenChanged, this, [this] {
        m_model->setHidden(m_selection.hidden());
        updateState();
    });
    connect(&m_bakes, &Bakes::changed, this, [this](Id asset) {
        if (asset == m_selection.asset()) bakeChanged();
    });
}

/// Room for headers and four digits; what the user made wider stays so.
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
    takeFilter();
}

void FragmentTable::showMenu(const QPoint& position) {
    QMenu menu;
    menu.setToolTipsVisible(true);
    menu.addActions({m_hide, m_show, m_showAll, m_isolate});
    menu.addSeparator();
    menu.addAction(m_invert);
    menu.addSeparator();
    menu.addActions(m_pieceActions);
    menu.exec(m_view->viewport()->mapToGlobal(position));
}

/// Keys of the table come before those of the window.
bool FragmentTable::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
    const QKeySequence key(static_cast<QKeyEvent*>(event)->keyCombination());
    for (QAction* action : {m_hide, m_showAll, m_isolate, m_invert}) {
        if (action->shortcut() != key) continue;
        event->accept();
        if (!isOverride) action->trigger();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

void FragmentTable::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    if (m_isStale) takeBake();
}

void FragmentTable::takeAsset() {
    bakeChanged();
    m_view->scrollToTop();
}

void FragmentTable::bakeChanged() {
    m_isStale = true;
    if (isVisible()) takeBake();
}

void FragmentTable::takeBake() {
    m_isStale = false;
    const std::shared_ptr<const BakedAsset> baked = m_bakes.find(m_selection.asset());
    const bool hasBake = baked && baked->bake;
    m_model->setFigures(hasBake ? FragmentFigures(baked->bake, density(), std::max(1, QThread::idealThreadCount()))
                                : FragmentFigures());
    takeProblems();
}

void FragmentTable::setProblems(const ProblemWatch& watch) {
    m_watch = &watch;
    connect(&watch, &ProblemWatch::changed, this, &FragmentTable::takeProblems);
    takeProblems();
}

/// They are found a moment after the bake.
void FragmentTable::takeProblems() {
    const bool isOfBake = m_watch && m_watch->bakeOf(m_selection.asset()) == m_model->figures().bake();
    if (isOfBake && m_model->figures().bake()) m_model->setProblems(m_watch->of(m_selection.asset()));
}

/// Chooses listed fragments, as their bars hold them.
void FragmentTable::takeRange(double least, double most, bool isMore) {
    const std::shared_ptr<const Bake>& bake = m_model->figures().bake();
    if (!bake) return;
    FragmentSet chosen = fragmentsOfVolume(*bake, least, most);
    const FragmentSet shown = m_model->shownFragments(), before = m_model->fragmentsOf(m_selection.choice());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        chosen[k] = (chosen[k] && shown[k]) || (isMore && before[k]);
    }
    m_selection.setChoice(choiceOf(chosen, *bake, m_selection.inside()));
}

/// Of the listed fragments that are not broken again: others are counted by their pieces.
void FragmentTable::updateHistogram() {
    std::vector<double> volumes;
    std::vector<bool> isChosen;
    if (const std::shared_ptr<const Bake>& bake = m_model->figures().bake()) {
        const FragmentSet smallest = smallestFragments(*bake), shown = m_model->shownFragments();
        const FragmentSet chosen = withPieces(*bake, m_model->fragmentsOf(m_selection.choice()));
        for (std::uint32_t k = 0; k < smallest.size(); ++k) {
            if (!smallest[k] || !shown[k]) continue;
            volumes.push_back(m_model->figures().value(FragmentColumn::Volume, k));
            isChosen.push_back(chosen[k]);
        }
    }
    m_histogram->setVolumes(std::move(volumes), std::move(isChosen));
}

double FragmentTable::density() const {
    const Material* material = asset() ? findMaterial(m_document.project(), asset()->material) : nullptr;
    return material ? material->density : 0.0;
}

void FragmentTable::takeChanges(const Changes& changes) {
    const bool isOfMass = changes.touches(Part::Material) || changes.touches(Part::Asset, m_selection.asset());
    if (isOfMass) m_model->setDensity(density());
}

void FragmentTable::takeFilter() {
    Result<FragmentFilter> filter = fragmentFilter(m_filter->text(), m_units, locale());
    m_filterFault = filter ? QString() : QString::fromStdString(filter.error().message);
    if (filter) m_model->setFilter(std::move(*filter));
    updateState();
}

void FragmentTable::keepPlace() {
    m_keptRow = m_view->currentIndex().row();
    m_keptScroll = m_view->verticalScrollBar()->value();
}

void FragmentTable::restorePlace() {
    m_view->doItemsLayout();  // at once, as the scroll bar's range is that of the old rows
    if (m_keptRow >= 0 && m_model->rowCount() > 0) {
        const QModelIndex current = m_model->index(std::min(m_keptRow, m_model->rowCount() - 1), 0);
        m_view->selectionModel()->setCurrentIndex(current, QItemSelectionModel::NoUpdate);
    }
    m_view->verticalScrollBar()->setValue(m_keptScroll);
    selectRows();
    updateState();
}

void FragmentTable::takeFromView() {
    if (m_isShowing || !m_model->figures().bake()) return;
    const std::vector<bool> isSelected = selectedRows(*m_view);
    FragmentSet chosen(m_model->figures().count(), false);
    for (int row = 0; row < m_model->rowCount(); ++row) {
        if (isSelected[static_cast<std::size_t>(row)]) chosen[m_model->fragmentAt(row)] = true;
    }
    const QScopedValueRollback taking(m_isTaking, true);
    m_selection.setChoice(choiceOf(chosen, *m_model->figures().bake(), m_selection.inside()));
    updateState();
}

void FragmentTable::showSelection() {
    if (m_isTaking) return;
    selectRows();
    scrollToChosen();
    updateState();
}

/// Selects the rows of the chosen fragments, unless they are already.
void FragmentTable::selectRows() {
    const FragmentSet isChosen = m_model->fragmentsOf(m_selection.choice());
    std::vector<bool> isWanted;
    for (int row = 0; row < m_model->rowCount(); ++row) isWanted.push_back(isChosen[m_model->fragmentAt(row)]);
    if (isWanted == selectedRows(*m_view)) return;
    const QScopedValueRollback showing(m_isShowing, true);
    QItemSelectionModel& rows = *m_view->selectionModel();
    rows.clearSelection();  // first, as two long lists of ranges are compared each with each
    rows.select(rowRanges(isWanted, *m_model), QItemSelectionModel::Select);
    rows.select(QItemSelection(), QItemSelectionModel::Select);  // what the mouse goes on to select is added to it
}

/// Shows the first chosen row unless one is in sight.
void FragmentTable::scrollToChosen() {
    const std::vector<bool> isSelected = selectedRows(*m_view);
    const auto first = std::ranges::find(isSelected, true);
    if (first == isSelected.end()) return;
    const int top = std::max(0, m_view->rowAt(0)), bottom = m_view->rowAt(m_view->viewport()->height() - 1);
    const auto end = bottom < 0 ? isSelected.end() : isSelected.begin() + bottom + 1;
    if (std::find(isSelected.begin() + top, end, true) != end) return;
    m_view->scrollTo(m_model->index(static_cast<int>(first - isSelected.begin()), 0));
}

void FragmentTable::hideChosen() {
    if (const Bake* bake = takenBake()) rubble::hideChosen(m_selection, *bake);
}

void FragmentTable::showChosen() {
    if (const Bake* bake = takenBake()) rubble::showChosen(m_selection, *bake);
}

void FragmentTable::showAll() { showAllFragments(m_selection); }

void FragmentTable::isolateChosen() {
    if (const Bake* bake = takenBake()) rubble::isolateChosen(m_selection, *bake);
}

void FragmentTable::invertChoice() {
    const Bake* bake = takenBake();
    if (!bake) return;
    FragmentSet rest = m_model->shownFragments();
    const FragmentSet chosen = m_model->fragmentsOf(m_selection.choice());
    for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = rest[k] && !chosen[k];
    m_selection.setChoice(choiceOf(rest, *bake, m_selection.inside()));
}

/// The bake that the rows are of; null where there is none.
const Bake* FragmentTable::takenBake() {
    if (m_isStale) takeBake();
    return m_model->figures().bake().get();
}

void FragmentTable::updateState() {
    const FragmentChoice &chosen = m_selection.choice(), &hidden = m_selection.hidden();
    m_hide->setEnabled(!chosen.isEmpty());
    m_show->setEnabled(std::ranges::any_of(chosen.seeds, [&](SeedId seed) { return hidden.seeds.contains(seed); }));
    m_showAll->setEnabled(!hidden.isEmpty());
    m_isolate->setEnabled(!chosen.isEmpty());
    m_invert->setEnabled(m_model->rowCount() > 0);
    m_totals->setText(totals());
    updateHistogram();
}

QString FragmentTable::totals() const {
    if (!m_filterFault.isEmpty()) return m_filterFault;
    if (!asset()) return tr("No asset is at hand. Add one, or choose one in the project tree.");
    const std::shared_ptr<const BakedAsset> baked = m_bakes.find(m_selection.asset());
    if (!baked) return tr("The fragments are being made.");
    if (!baked->bake) return QString::fromStdString(baked->fault->message);
    const FragmentSum shown = m_model->figures().sum(m_model->shownFragments());
    const FragmentSum chosen = m_model->figures().sum(m_model->fragmentsOf(m_selection.choice()));
    const QString count = locale().toString(m_model->figures().count());
    const QString listed = tr("Listed: %1 of %2").arg(locale().toString(shown.count), count) + sumText(shown);
    if (chosen.count == 0) return listed;
    return tr("%1 · Chosen: %2").arg(listed, locale().toString(chosen.count)) + sumText(chosen);
}

/// ", 0.25 m³, 250 kg"
QString FragmentTable::sumText(const FragmentSum& sum) const {
    if (sum.count == 0) return {};
    const NumberFormat volumes = m_units.volumes(), masses = formatOf(FragmentColumn::Mass, m_units);
    return tr(", %1, %2")
        .arg(withUnit(roundedText(sum.volume, kSumDigits, volumes, locale()), volumes),
             withUnit(roundedText(sum.mass, kSumDigits, masses, locale()), masses));
}

}  // namespace rubble
