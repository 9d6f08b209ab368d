#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class MainWindow;

/// Edit menu: steps back and forth, and what is done to the chosen seeds.
class EditActions : public QObject {
    Q_OBJECT
public:
    explicit EditActions(MainWindow& window);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const { return {m_undo, m_redo}; }

private:
    void deleteSeeds();
    void restoreSeeds();
    void openPreferences();
    void update();

    MainWindow& m_window;
    QMenu* m_menu;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QList<QAction*> m_forSeeds;  // those that need chosen seeds
};

}  // namespace rubble
