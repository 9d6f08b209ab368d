#pragma once

#include "editor/document/StateComparison.h"

#include <QDockWidget>
#include <QObject>

class QAction;

namespace rubble {

class ChangesPanel;
class MainWindow;

/// A dock that tells when the user closes it, and not when it is hidden with others.
class ClosingDock : public QDockWidget {
    Q_OBJECT
public:
    using QDockWidget::QDockWidget;

signals:
    void closed();

protected:
    void closeEvent(QCloseEvent* event) override;
};

/// Two commands of the Asset menu: what changed since the project was saved, or since another saved state of it. While that is
/// shown, the canvas marks the pieces that changed and a dock tells of them; Escape or closing the dock ends it.
class WhatChanged : public QObject {
    Q_OBJECT
public:
    explicit WhatChanged(MainWindow& window);

    QList<QAction*> actions() const { return {m_sinceSaving, m_sinceFile}; }
    StateComparison& comparison() { return m_comparison; }
    ChangesPanel& panel() { return *m_panel; }

private:
    void compareWithSaved();
    void compareWithFile();
    void compareWith(const QString& path, const QString& name);
    void end();
    void show();
    void jump(const PieceDifference& piece);
    void update();

    MainWindow& m_window;
    StateComparison m_comparison;
    ChangesPanel* m_panel;
    ClosingDock* m_dock;
    QAction* m_sinceSaving;
    QAction* m_sinceFile;
};

}  // namespace rubble
