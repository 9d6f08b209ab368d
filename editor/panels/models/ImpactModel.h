#pragma once

#include "editor/play/PlayFrame.h"

#include <QAbstractTableModel>

namespace rubble {

/// The impacts of a play session as a table, in order of time: what broke, and what stayed whole.
class ImpactModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kName, kRatio, kImpact, kThreshold, kFragments, kCost, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows these impacts; `stepLength` in s. Impacts that only follow those shown are inserted without a reset of
    /// the model.
    void setImpacts(const std::vector<ImpactRecord>& impacts, double stepLength);
    const ImpactRecord& impact(int row) const { return m_impacts[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QVariant text(const ImpactRecord& record, int column) const;

    std::vector<ImpactRecord> m_impacts;
    double m_stepLength = 1.0 / 60.0;
};

}  // namespace rubble
