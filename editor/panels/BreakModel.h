#pragma once

#include "editor/play/PlayFrame.h"

#include <QAbstractTableModel>

namespace rubble {

/// What broke in a play, in order.
class BreakModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kTime, kName, kRatio, kImpact, kThreshold, kPieces, kCost, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// `stepLength` in s. What is there already stays, so that a view need not begin anew.
    void setBreaks(const std::vector<ToldBreak>& breaks, double stepLength);
    const ToldBreak& broken(int row) const { return m_breaks[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QVariant text(const ToldBreak& broken, int column) const;

    std::vector<ToldBreak> m_breaks;
    double m_stepLength = 1.0 / 60.0;
};

}  // namespace rubble
