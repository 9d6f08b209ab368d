#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/FragmentFilter.h"

#include <QAbstractTableModel>

#include <vector>

namespace rubble {

/// The fragments of one bake as the rows of a table: those that a filter takes, in the order of a column. Figures and order
/// are kept in flat arrays; texts are made for what is looked at only. Whatever changes the rows resets the model.
class FragmentModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    const FragmentFigures& figures() const { return m_figures; }
    void setFigures(FragmentFigures figures);
    void setDensity(double density);
    void setProblems(std::span<const Problem> problems);
    void setFilter(FragmentFilter filter);
    void setUnits(const Units& units);
    /// These are shown pale.
    void setHidden(const FragmentChoice& hidden);

    std::uint32_t fragmentAt(int row) const { return m_rows[static_cast<std::size_t>(row)]; }
    /// One mark a fragment: it has a row.
    FragmentSet shownFragments() const;
    /// One mark a fragment: the choice names it.
    FragmentSet fragmentsOf(const FragmentChoice& choice) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// By value, equal ones in the order of their ids.
    void sort(int column, Qt::SortOrder order) override;

private:
    void arrange();
    QString text(FragmentColumn column, std::uint32_t fragment) const;
    QString hint(FragmentColumn column, std::uint32_t fragment) const;

    FragmentFigures m_figures;
    FragmentFilter m_filter;
    Units m_units;
    FragmentColumn m_sortColumn = FragmentColumn::Name;
    Qt::SortOrder m_sortOrder = Qt::AscendingOrder;
    std::vector<std::uint32_t> m_rows;  // fragment of each row
    std::vector<bool> m_isHidden;       // one a fragment
    FragmentChoice m_hidden;
};

}  // namespace rubble
