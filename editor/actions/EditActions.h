#pragma once

#include <QObject>

class QAction;
class QMenu;

namespace rubble {

class PreferenceStore;
class Views;
class Workspace;

/// The Edit menu: undo and redo, the selected seeds, and the preferences.
class EditActions : public QObject {
    Q_OBJECT
public:
    EditActions(Views& views, PreferenceStore& preferences);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> toolbarActions() const { return {m_undo, m_redo}; }

private:
    void deleteSeeds();
    void restoreSeeds();
    void openPreferences();
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    PreferenceStore& m_preferences;
    QMenu* m_menu;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_deleteSeeds = nullptr;
};

}  // namespace rubble
