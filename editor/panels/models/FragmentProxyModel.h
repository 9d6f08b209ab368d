#pragma once

#include "editor/panels/models/FragmentModel.h"

#include <QSortFilterProxyModel>

namespace rubble {

/// The rows of a FragmentModel, filtered and sorted. Both read the metrics directly, not through QVariant, and a change
/// of the filter resets the source model, since invalidateFilter() emits signals for every run of rows: so that 50,000
/// fragments are filtered and sorted in a few tens of milliseconds.
class FragmentProxyModel : public QSortFilterProxyModel {
    Q_OBJECT
public:
    explicit FragmentProxyModel(FragmentModel& model, QObject* parent = nullptr);

    void setFilter(FragmentFilter filter);
    std::uint32_t fragmentAt(int row) const;
    /// One flag per fragment: whether it has a row.
    FragmentSet listedFragments() const;

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
    /// Compares by value; fragments with equal values stay in ascending order of their ids.
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

private:
    FragmentModel& m_model;
    FragmentFilter m_filter;
};

}  // namespace rubble
