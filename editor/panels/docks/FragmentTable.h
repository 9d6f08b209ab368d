#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/panels/models/FragmentProxyModel.h"

#include <QWidget>

class QAction;
class QBoxLayout;
class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;

namespace rubble {

class ProblemWatch;
class VolumeHistogram;

/// The dock that lists the fragments of the active asset with their metrics beside a histogram of their volumes. Rows
/// are sorted by any column, filtered (see fragmentFilter()), and selected and hidden together with canvas and 3D view.
///
/// Selecting a fragment does not select its child fragments, but hiding it hides them. Metrics are computed once per
/// bake, when the table is visible.
class FragmentTable : public QWidget {
    Q_OBJECT
public:
    FragmentTable(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);

    QTableView& view() { return *m_view; }
    VolumeHistogram& histogram() { return *m_histogram; }
    /// Shows the problems of the fragments.
    void setProblems(const ProblemWatch& watch);
    void setUnits(const Units& units);
    /// Sets the actions on the selected fragments in the context menu. Those that hide and show fragments also get
    /// buttons, and their shortcuts work while the table has the focus.
    void setFragmentActions(const QList<QAction*>& visibility, const QList<QAction*>& others);

    void showSelected();
    /// Selects the listed fragments that are not selected, and deselects all others.
    void invertSelection();

signals:
    /// The selected fragments are to be framed.
    void frameRequested();

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildView();
    void buildFilter();
    void buildActions();
    void connectAll();
    void widenColumns();
    void showMenu(const QPoint& position);

    void refreshAsset();
    void bakeChanged();
    void refreshBake();
    void refreshDensity(const Changes& changes);
    void applyFilter();
    void applyViewSelection();
    void refreshProblems();
    void selectRange(double min, double max, bool isExtending);
    void updateHistogram();
    void showSelection();
    void selectRows();
    void scrollToSelection();
    void saveScrollPosition();
    void restoreScrollPosition();

    const Asset* asset() const { return findAsset(m_document.project(), m_selection.asset()); }
    double density() const;
    const Bake* currentBake();
    void updateState();
    QString totals() const;
    QString sumText(const FragmentSum& sum) const;

    Document& m_document;
    Selection& m_selection;
    const Bakes& m_bakes;
    FragmentModel* m_model;
    FragmentProxyModel* m_listed;
    QTableView* m_view;
    VolumeHistogram* m_histogram;
    const ProblemWatch* m_watch = nullptr;  // null: problems are not shown
    QLineEdit* m_filter;
    QBoxLayout* m_buttons;
    QLabel* m_totals;
    QAction* m_show = nullptr;
    QAction* m_invert = nullptr;
    QAction* m_frame = nullptr;
    QList<QAction*> m_visibilityActions;
    QList<QAction*> m_fragmentActions;

    Units m_units;
    QString m_filterFault;      // what is wrong with the filter; empty: nothing
    bool m_isStale = true;      // the bake may have changed
    bool m_isApplying = false;  // the selection is being copied from the view
    bool m_isShowing = false;   // the selection is being copied to the view
    int m_savedRow = -1;
    int m_savedScroll = 0;
};

}  // namespace rubble
