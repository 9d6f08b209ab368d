#pragma once

#include "editor/document/ProblemWatch.h"
#include "editor/document/Selection.h"
#include "editor/panels/FixRunner.h"
#include "editor/panels/ProblemModel.h"

#include <QWidget>

#include <vector>

class QCheckBox;
class QLabel;
class QToolButton;
class QTreeView;

namespace rubble {

/// The dock that lists what an artist should look at. Enter or a double click goes to the place; a button for each fix that
/// can be tried on the chosen rows carries it out as one step; while that takes long, a button cancels it.
class ProblemPanel : public QWidget {
    Q_OBJECT
public:
    ProblemPanel(Document& document, Selection& selection, const ProblemWatch& watch, QWidget* parent = nullptr);

    QTreeView& view() { return *m_view; }
    const ProblemModel& model() const { return *m_model; }
    void setUnits(const Units& units) { m_model->setUnits(units); }

signals:
    void jumpRequested(const rubble::Problem& problem);
    void countChanged(int count);
    void said(const QString& sentence);

private:
    void buildView();
    QWidget* makeBar();
    void take();
    void widenColumns();
    void update();
    QWidget* makeCancel();
    QString summary(std::size_t chosen) const;
    std::vector<Problem> chosen() const;

    struct Button {
        ProblemFix fix;
        QToolButton* widget;
    };

    Document& m_document;
    Selection& m_selection;
    const ProblemWatch& m_watch;
    ProblemModel* m_model;
    QTreeView* m_view;
    QCheckBox* m_isAtHandOnly;
    QLabel* m_summary;
    FixRunner* m_runner;
    QToolButton* m_cancel = nullptr;
    std::vector<Button> m_fixes;
};

}  // namespace rubble
