#pragma once

#include "editor/document/Bakes.h"
#include "editor/document/Document.h"
#include "editor/panels/FragmentModel.h"

#include <QWidget>

class QAction;
class QBoxLayout;
class QKeySequence;
class QLabel;
class QLineEdit;
class QTableView;

namespace rubble {

class ProblemWatch;
class VolumeHistogram;

/// The dock that lists the fragments of the asset at hand with their figures, beside a histogram of their volumes: sorted by
/// any figure, filtered (see fragmentFilter), chosen in step with canvas and viewport, hidden (H), shown again (Alt+H) and isolated (Shift+H).
///
/// A fragment of several levels is chosen by itself; hidden it is with its pieces. Figures are computed once a bake, and not before the table is visible.
class FragmentTable : public QWidget {
    Q_OBJECT
public:
    FragmentTable(Document& document, Selection& selection, const Bakes& bakes, QWidget* parent = nullptr);

    QTableView& view() { return *m_view; }
    VolumeHistogram& histogram() { return *m_histogram; }
    /// Lets the list tell what is to be looked at.
    void setProblems(const ProblemWatch& watch);
    void setUnits(const Units& units);
    /// What its menu offers to go into a fragment and out of it.
    void setPieceActions(const QList<QAction*>& actions) { m_pieceActions = actions; }

    /// Hides what is chosen, and lets go of it.
    void hideChosen();
    void showChosen();
    void showAll();
    /// Hides all but what is chosen.
    void isolateChosen();
    /// Chooses what has a row and is not chosen, and lets go of the rest.
    void invertChoice();

protected:
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Deed = void (FragmentTable::*)();

    void buildView();
    void buildFilter();
    void buildActions();
    void addButtons(QBoxLayout& row);
    void connectAll();
    QAction* newAction(const QString& icon, const QString& text, const QString& hint, const QKeySequence& key,
                       Deed deed);
    void widenColumns();
    void showMenu(const QPoint& position);

    void takeAsset();
    void bakeChanged();
    void takeBake();
    void takeChanges(const Changes& changes);
    void takeFilter();
    void takeFromView();
    void takeProblems();
    void takeRange(double least, double most, bool isMore);
    void updateHistogram();
    void showSelection();
    void selectRows();
    void scrollToChosen();
    void keepPlace();
    void restorePlace();

    const Asset* asset() const { return findAsset(m_document.project(), m_selection.asset()); }
    double density() const;
    const Bake* takenBake();
    void updateState();
    QString totals() const;
    QString sumText(const FragmentSum& sum) const;

    Document& m_document;
    Selection& m_selection;
    const Bakes& m_bakes;
    FragmentModel* m_model;
    QTableView* m_view;
    VolumeHistogram* m_histogram;
    const ProblemWatch* m_watch = nullptr;  // null: problems are not told
    QLineEdit* m_filter;
    QLabel* m_totals;
    QAction* m_hide = nullptr;
    QAction* m_show = nullptr;
    QAction* m_showAll = nullptr;
    QAction* m_isolate = nullptr;
    QAction* m_invert = nullptr;
    QList<QAction*> m_pieceActions;

    Units m_units;
    QString m_filterFault;     // why the filter cannot be read; empty: it can
    bool m_isStale = true;     // there may be another bake than the one shown
    bool m_isTaking = false;   // the selection follows the view now
    bool m_isShowing = false;  // the view follows the selection now
    int m_keptRow = -1;
    int m_keptScroll = 0;
};

}  // namespace rubble
