#pragma once

#include "editor/document/Edit.h"

#include <QObject>

#include <span>

class QAction;
class QMenu;

namespace rubble {

class SceneView;
class TransformTool;
class VisibilityActions;
class Views;
class Workspace;
struct ActionDefinition;

/// The Instance menu: placing instances and editing the selected ones. Its shortcuts work while the 3D view has the
/// focus; its actions are also in the context menus of 3D view and project tree.
class InstanceActions : public QObject {
    Q_OBJECT
public:
    InstanceActions(Views& views, const VisibilityActions& visibility);

    QMenu* menu() const { return m_menu; }

private:
    using Slot = void (InstanceActions::*)();
    using InstanceEdit = Edit (*)(const Project&, std::span<const Id> instances);

    QAction* add(const ActionDefinition& definition);
    QAction* add(const ActionDefinition& definition, Slot slot);
    /// Adds an action that applies an edit to the selected instances.
    QAction* addEdit(const ActionDefinition& definition, InstanceEdit edit);
    void addTransforms();
    void addHandles();
    void addCopies();
    void addAnchors();
    void joinWithMortar();
    void addLocks();
    void addContextMenus();
    void startPlacing();
    void place(Id asset);
    void move();
    void rotate();
    void drop();
    void duplicate();
    void arrayInGrid();
    void arrayInRing();
    void addArray(const QString& text, const Edit& edit, bool haveVariants);
    void unlockAll();
    void selectAddedSince(Id first);
    void updateEnabled();

    std::vector<Id> selected() const;
    SceneView& scene() const;
    TransformTool& gizmo() const;

    Views& m_views;
    Workspace& m_workspace;
    QMenu* m_menu;
    QAction* m_place = nullptr;
    QAction* m_unlockAll = nullptr;
    QAction* m_anchored = nullptr;  // checked if all selected bonded instances are
    QAction* m_mortar = nullptr;
    QList<QAction*> m_needSelection;  // enabled while instances are selected
    QList<QAction*> m_needMovable;    // enabled while one of them is neither locked nor hidden
};

}  // namespace rubble
