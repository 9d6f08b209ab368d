#pragma once

#include "editor/panels/inspector/NumberDelegate.h"

#include <QTableView>

#include <vector>

namespace rubble {

/// A table of numbers to edit, as high as its rows.
class NumberTable : public QTableView {
    Q_OBJECT
public:
    /// `prepare`: see NumberDelegate.
    NumberTable(QAbstractItemModel& model, NumberDelegate::Prepare prepare, QWidget* parent);

    /// Fits the height to the rows, but at least and at most to these numbers of rows.
    void fitHeight(int leastRows, int mostRows);
    /// The rows with selected cells, ascending, each once.
    std::vector<int> selectedRows() const;
    /// Shows why an edit was refused, below the current cell.
    void showRefusal(const QString& sentence);
};

}  // namespace rubble
