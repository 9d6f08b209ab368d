#pragma once

#include "editor/commands/FragmentEdits.h"

#include <QObject>

#include <vector>

class QAction;
class QMenu;

namespace rubble {

class Views;
class Workspace;

/// The Fragments menu: editing the selected fragments, entering and exiting a fragment.
class FragmentActions : public QObject {
    Q_OBJECT
public:
    explicit FragmentActions(Views& views);

    QMenu* menu() const { return m_menu; }
    QList<QAction*> navigationActions() const { return {m_enter, m_exit}; }
    QList<QAction*> editingActions() const {
        return {m_fracture, m_keepWhole, m_merge, m_split, m_restore, m_clusters};
    }

private:
    using FragmentEdit = Edit (*)(const Project&, Id asset, const std::vector<SelectedFragment>& fragments);

    /// Adds an action that applies an edit to the selected fragments.
    QAction* addEdit(const struct ActionDefinition& definition, FragmentEdit edit);
    bool push(FragmentEdit edit, const std::vector<SelectedFragment>& fragments);
    std::vector<SelectedFragment> selectedFragments() const;
    void fractureSelected();
    void mergeSelected();
    void restore();
    void enterSelected();
    QString severalSelectedText() const;
    void exitFragment();
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    QMenu* m_menu;
    QAction* m_fracture = nullptr;
    QAction* m_keepWhole = nullptr;
    QAction* m_merge = nullptr;
    QAction* m_split = nullptr;
    QAction* m_restore = nullptr;
    QAction* m_clusters = nullptr;  // the submenu
    QAction* m_enter = nullptr;
    QAction* m_exit = nullptr;
};

}  // namespace rubble
