#pragma once

#include "editor/play/PlayFrame.h"

#include <QAbstractTableModel>

namespace rubble {

/// The breaks of a play session as a table, in order of time.
class BreakModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kName, kRatio, kImpact, kThreshold, kPieces, kCost, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows these breaks; `stepLength` in s. Breaks that only follow those shown are inserted without a reset of the
    /// model.
    void setBreaks(const std::vector<BreakRecord>& breaks, double stepLength);
    const BreakRecord& broken(int row) const { return m_breaks[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QVariant text(const BreakRecord& broken, int column) const;

    std::vector<BreakRecord> m_breaks;
    double m_stepLength = 1.0 / 60.0;
};

}  // namespace rubble
