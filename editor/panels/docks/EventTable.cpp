#include "editor/panels/docks/EventTable.h"

#include "editor/widgets/appearance/EventAppearance.h"

#include <QAction>
#include <QHeaderView>
#include <QScrollBar>

#include <algorithm>
#include <array>

namespace rubble {

namespace {

constexpr int kEventRowMargin = 6;    // pixels that a row is higher than its text
constexpr int kEventCellMargin = 12;  // pixels that a column is wider than its texts
constexpr int kSortMargin = 18;       // and than its title, with the sign of sorting

/// The names in settings.
constexpr std::array<const char*, EventModel::kColumns> kColumnNames{
    "kind",   "time", "body",  "other",     "ratio",     "impulse", "speed",
    "energy", "mass", "count", "materials", "threshold", "cost"};

/// A long text of a column.
QString sampleOf(int column) {
    switch (column) {
        case EventModel::kKind: return titleOf(EventKind::Detached);
        case EventModel::kBody:
        case EventModel::kOther: return QStringLiteral("roof front right/12");
        case EventModel::kMaterials: return QStringLiteral("concrete, glass");
        case EventModel::kTime: return QStringLiteral("000.00");
        case EventModel::kRatio: return QStringLiteral("0.0000×");
        default: return QStringLiteral("0.0000 N·s");
    }
}

}  // namespace

EventTable::EventTable(QWidget* parent) : QTableView(parent), m_model(new EventModel(this)) {
    setModel(m_model);
    setObjectName("events");
    setAccessibleName(tr("Events"));
    setAccessibleDescription(tr("What happened in the simulation, with bodies, impulses and energies"));
    setShowGrid(false);
    setAlternatingRowColors(true);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kEventRowMargin);
    horizontalHeader()->setHighlightSections(false);
    sortByColumn(EventModel::kTime, Qt::AscendingOrder);
    setSortingEnabled(true);
    widenColumns();
    addColumnMenu();
    setHiddenColumns(hiddenByDefault());
    connect(this, &QTableView::activated, this,
            [this](const QModelIndex& index) { emit eventActivated(m_model->event(index.row())); });
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &EventTable::eventSelected);
    connect(m_model, &QAbstractItemModel::modelReset, this, &EventTable::eventSelected);
}

void EventTable::setEvents(const std::vector<EventRef>& events, double stepLength) {
    const EventRef selected = selectedEvent();
    const bool isAtEnd = verticalScrollBar()->value() == verticalScrollBar()->maximum();
    m_model->setEvents(events, stepLength);
    if (selected && !selectedEvent()) {
        if (const int row = m_model->rowOf(selected); row >= 0) selectRow(row);
    }
    if (isAtEnd) scrollToBottom();
}

EventRef EventTable::selectedEvent() const {
    const QModelIndexList rows = selectionModel()->selectedRows();
    return rows.isEmpty() ? nullptr : m_model->event(rows.front().row());
}

void EventTable::addColumnMenu() {
    QHeaderView& header = *horizontalHeader();
    for (int column = 0; column < EventModel::kColumns; ++column) {
        auto* action = new QAction(m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(), &header);
        action->setCheckable(true);
        action->setChecked(true);
        action->setEnabled(column != EventModel::kKind);  // one column stays: its header has this menu
        action->setObjectName(kColumnNames[static_cast<std::size_t>(column)]);
        connect(action, &QAction::toggled, this, [this, column](bool isOn) { setColumnHidden(column, !isOn); });
        header.addAction(action);
    }
    header.setContextMenuPolicy(Qt::ActionsContextMenu);
}

QStringList EventTable::hiddenColumns() const {
    QStringList names;
    for (const QAction* action : horizontalHeader()->actions()) {
        if (!action->isChecked()) names << action->objectName();
    }
    return names;
}

void EventTable::setHiddenColumns(const QStringList& names) {
    for (QAction* action : horizontalHeader()->actions()) {
        if (action->isEnabled()) action->setChecked(!names.contains(action->objectName()));
    }
}

QStringList EventTable::hiddenByDefault() { return {QStringLiteral("threshold"), QStringLiteral("cost")}; }

/// Fits columns to their titles and to long values; the names of bodies get the remaining width.
void EventTable::widenColumns() {
    QHeaderView& header = *horizontalHeader();
    const auto width = [this](const QString& text) { return fontMetrics().horizontalAdvance(text); };
    const int iconSpace = style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, this) + kEventCellMargin / 2;
    header.setMinimumSectionSize(width(QStringLiteral("000")) + kEventCellMargin);
    for (int column = 0; column < EventModel::kColumns; ++column) {
        const QString title = m_model->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
        const int icon = column == EventModel::kKind ? iconSpace : 0;
        header.resizeSection(column,
                             std::max(width(title) + kSortMargin, width(sampleOf(column)) + kEventCellMargin + icon));
    }
    header.setStretchLastSection(true);
}

}  // namespace rubble

#include "moc_EventTable.cpp"
