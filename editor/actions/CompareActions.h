#pragma once

#include "editor/background/StateComparison.h"

#include <QDockWidget>
#include <QObject>

class QAction;

namespace rubble {

class ChangesPanel;
class Views;
class Workspace;

/// A dock that reports when the user closes it, but not when it is hidden together with others.
class ClosableDock : public QDockWidget {
    Q_OBJECT
public:
    using QDockWidget::QDockWidget;

signals:
    void closed();

protected:
    void closeEvent(QCloseEvent* event) override;
};

/// The actions that compare the project with its saved state or with another project file. During a comparison the
/// canvas marks the fragments that changed and the Changes dock lists them; Escape or closing the dock ends it.
class CompareActions : public QObject {
    Q_OBJECT
public:
    explicit CompareActions(Views& views);

    QList<QAction*> actions() const { return {m_compareWithSaved, m_compareWithFile}; }
    StateComparison& comparison() { return m_comparison; }
    ChangesPanel& panel() { return *m_panel; }

    /// Compares with the project's file, as it is on the disk.
    void compareWithFileOnDisk();

private:
    void compareWithSaved();
    void compareWithFile();
    void compareWith(const QString& path, const QString& name);
    void end();
    void updateCanvas();
    void reveal(const FragmentDifference& fragment);
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    StateComparison m_comparison;
    ChangesPanel* m_panel;
    ClosableDock* m_dock;
    QAction* m_compareWithSaved;
    QAction* m_compareWithFile;
};

}  // namespace rubble
