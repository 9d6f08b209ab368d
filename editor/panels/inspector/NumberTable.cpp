#include "editor/panels/inspector/NumberTable.h"

#include <QHeaderView>
#include <QToolTip>

#include <algorithm>
#include <set>
#include <utility>

namespace rubble {

namespace {

constexpr int kRowPadding = 8;  // pixels

}  // namespace

NumberTable::NumberTable(QAbstractItemModel& model, NumberDelegate::Prepare prepare, QWidget* parent)
    : QTableView(parent) {
    setModel(&model);
    setItemDelegate(new NumberDelegate(std::move(prepare), this));
    setTabKeyNavigation(false);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                    QAbstractItemView::AnyKeyPressed);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setHighlightSections(false);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + kRowPadding);
}

void NumberTable::fitHeight(int leastRows, int mostRows) {
    const int rows = std::clamp(model()->rowCount(), leastRows, mostRows);
    setFixedHeight(rows * verticalHeader()->defaultSectionSize() + horizontalHeader()->sizeHint().height() +
                   2 * frameWidth());
}

std::vector<int> NumberTable::selectedRows() const {
    std::set<int> rows;
    for (const QModelIndex& index : selectionModel()->selectedIndexes()) rows.insert(index.row());
    return {rows.begin(), rows.end()};
}

void NumberTable::showRefusal(const QString& sentence) {
    QToolTip::showText(viewport()->mapToGlobal(visualRect(currentIndex()).bottomLeft()), sentence, this);
}

}  // namespace rubble

#include "moc_NumberTable.cpp"
