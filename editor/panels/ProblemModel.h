#pragma once

#include "core/asset/Problems.h"
#include "editor/document/Document.h"
#include "editor/panels/Units.h"

#include <QAbstractTableModel>

#include <vector>

namespace rubble {

/// "Sliver", as a list shows it.
QString textOf(ProblemKind kind);

/// Problems as the rows of a list, in the order of a column.
class ProblemModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kWhat, kWhere, kAsset, kText, kFigure, kLimit, kColumns };

    ProblemModel(const Document& document, QObject* parent = nullptr);

    /// `ids`: of the fragments that they are about, one a problem; empty where it is about none.
    void setProblems(std::vector<Problem> problems, QStringList ids);
    void setUnits(const Units& units);
    const Problem& problem(int row) const { return m_problems[m_rows[static_cast<std::size_t>(row)]]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    /// By kind, name, place in the pattern, or by how bad they are.
    void sort(int column, Qt::SortOrder order) override;

private:
    void arrange();
    QString text(std::size_t problem, int column) const;
    QString where(std::size_t problem) const;
    QString figure(const Problem& problem, double value) const;

    const Document& m_document;
    std::vector<Problem> m_problems;
    QStringList m_ids;
    std::vector<std::size_t> m_rows;  // into the problems
    Units m_units;
    int m_sortColumn = kFigure;
    Qt::SortOrder m_sortOrder = Qt::DescendingOrder;
};

}  // namespace rubble
