#pragma once

#include "editor/document/Selection.h"
#include "editor/panels/models/FragmentFilter.h"

#include <QAbstractTableModel>

#include <vector>

namespace rubble {

/// The fragments of one bake as a table, row k being fragment k. Values are flat arrays, and texts are made for visible
/// rows only. Changes of values reset the model, since proxy models may reorder all rows.
class FragmentModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    const FragmentMetrics& metrics() const { return m_metrics; }
    void setMetrics(FragmentMetrics metrics);
    void setDensity(double density);
    void setProblems(std::span<const Diagnostic> problems);
    void setUnits(const Units& units);
    /// Hidden fragments are shown in a faded colour.
    void setHidden(const FragmentSelection& hidden);

    /// Makes views and proxy models read all rows again.
    void reset();
    /// One flag per fragment: whether the selection contains it.
    FragmentSet fragmentsOf(const FragmentSelection& selection) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(FragmentColumn column, std::uint32_t fragment) const;
    QString hint(FragmentColumn column, std::uint32_t fragment) const;

    FragmentMetrics m_metrics;
    Units m_units;
    std::vector<bool> m_isHidden;  // one flag per fragment
    FragmentSelection m_hidden;
};

}  // namespace rubble
