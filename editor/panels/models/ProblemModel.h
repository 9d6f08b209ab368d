#pragma once

#include "core/asset/checks/Problems.h"
#include "editor/document/Document.h"
#include "editor/widgets/numbers/Units.h"

#include <QAbstractTableModel>

#include <vector>

namespace rubble {

/// The translated name of a kind: "Sliver".
QString textOf(DiagnosticCode kind);

/// Problems as a table, in the order given. A proxy model sorts each column by kSortRole: numbers by badness().
class ProblemModel : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { kKind, kLocation, kAsset, kText, kValue, kLimit, kColumns };
    enum Role { kSortRole = Qt::UserRole };

    ProblemModel(const Document& document, QObject* parent = nullptr);

    /// ids[k] is the fragment of problem k, or empty.
    void setProblems(std::vector<Diagnostic> problems, QStringList ids);
    void setUnits(const Units& units);
    const Diagnostic& problem(int row) const { return m_problems[static_cast<std::size_t>(row)]; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QVariant sortKey(const Diagnostic& problem, int column) const;
    QString text(int row, int column) const;
    QString location(int row) const;
    QString valueText(const Diagnostic& problem, double value) const;

    const Document& m_document;
    std::vector<Diagnostic> m_problems;
    QStringList m_ids;
    Units m_units;
};

}  // namespace rubble
