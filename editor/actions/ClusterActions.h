#pragma once

#include "editor/commands/ClusterEdits.h"

#include <QObject>

#include <map>

class QAction;
class QMenu;

namespace rubble {

class Views;
class Workspace;

/// The menu Fragments ▸ Clusters: clusters of the fragments of the active asset, at the active level of clusters.
class ClusterActions : public QObject {
    Q_OBJECT
public:
    explicit ClusterActions(Views& views);

    QMenu* menu() const { return m_menu; }

private:
    void add(ClusterCommand command, const struct ActionDefinition& definition);
    void propose();
    void carryOut(ClusterCommand command);
    /// Pushes an edit, or says in the status bar why there is none.
    void push(Result<Edit> edit);
    /// The bake of the active asset; null, and said so, while there is none.
    std::shared_ptr<const Bake> readyBake() const;
    void updateEnabled();

    Views& m_views;
    Workspace& m_workspace;
    QMenu* m_menu;
    QAction* m_propose = nullptr;
    std::map<ClusterCommand, QAction*> m_actions;
    std::map<QAction*, QString> m_tips;  // of the enabled actions
    ClusterTarget m_target;              // of the last proposal
};

}  // namespace rubble
