#include "editor/panels/models/FragmentProxyModel.h"

namespace rubble {

FragmentProxyModel::FragmentProxyModel(FragmentModel& model, QObject* parent)
    : QSortFilterProxyModel(parent), m_model(model) {
    setDynamicSortFilter(false);  // the model resets when rows may move
    setSourceModel(&model);
}

void FragmentProxyModel::setFilter(FragmentFilter filter) {
    m_filter = std::move(filter);
    m_model.reset();
}

std::uint32_t FragmentProxyModel::fragmentAt(int row) const {
    return static_cast<std::uint32_t>(mapToSource(index(row, 0)).row());
}

FragmentSet FragmentProxyModel::listedFragments() const {
    FragmentSet isListed(m_model.metrics().count(), false);
    for (int row = 0; row < rowCount(); ++row) isListed[fragmentAt(row)] = true;
    return isListed;
}

bool FragmentProxyModel::filterAcceptsRow(int row, const QModelIndex&) const {
    return m_filter.accepts(m_model.metrics(), static_cast<std::uint32_t>(row));
}

bool FragmentProxyModel::lessThan(const QModelIndex& left, const QModelIndex& right) const {
    const FragmentMetrics& metrics = m_model.metrics();
    const auto a = static_cast<std::uint32_t>(left.row()), b = static_cast<std::uint32_t>(right.row());
    const double valueA = metrics.value(FragmentColumn(left.column()), a);
    const double valueB = metrics.value(FragmentColumn(left.column()), b);
    if (valueA != valueB) return valueA < valueB;
    const bool isBefore = metrics.value(FragmentColumn::Name, a) < metrics.value(FragmentColumn::Name, b);
    const bool isAfter = metrics.value(FragmentColumn::Name, a) > metrics.value(FragmentColumn::Name, b);
    return sortOrder() == Qt::AscendingOrder ? isBefore : isAfter;  // a descending sort swaps the arguments
}

}  // namespace rubble

#include "moc_FragmentProxyModel.cpp"
