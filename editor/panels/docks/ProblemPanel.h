#pragma once

#include "editor/background/ProblemWatch.h"
#include "editor/background/QuickFixRunner.h"
#include "editor/document/Selection.h"
#include "editor/panels/models/ProblemModel.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QSortFilterProxyModel;
class QToolButton;
class QTreeView;

namespace rubble {

/// The dock that lists problems with the assets. Activating a problem emits jumpRequested(). Buttons apply the quick
/// fixes that suit the selected rows, each as one undo step, and can be cancelled.
class ProblemPanel : public QWidget {
    Q_OBJECT
public:
    ProblemPanel(Document& document, Selection& selection, const ProblemWatch& watch, QWidget* parent = nullptr);

    QTreeView& view() { return *m_view; }
    /// The problem of a row of the view.
    const Diagnostic& problem(const QModelIndex& viewIndex) const;
    void setUnits(const Units& units) { m_model->setUnits(units); }

signals:
    void jumpRequested(const rubble::Diagnostic& problem);
    void countChanged(int count);
    void statusMessage(const QString& sentence);

private:
    void buildView();
    QWidget* makeBar();
    void refresh();
    void widenColumns();
    void refreshButtons();
    QWidget* makeCancel();
    QString summary(std::size_t selected) const;
    std::vector<Diagnostic> selected() const;

    struct Button {
        QuickFix fix;
        QToolButton* widget;
    };

    Document& m_document;
    Selection& m_selection;
    const ProblemWatch& m_watch;
    ProblemModel* m_model;
    QSortFilterProxyModel* m_sorted;
    QTreeView* m_view;
    QCheckBox* m_isActiveOnly;
    QLabel* m_summary;
    QLabel* m_description;  // of the selected problem, or why the search failed
    QuickFixRunner* m_runner;
    QToolButton* m_cancel = nullptr;
    std::vector<Button> m_fixes;
};

}  // namespace rubble
