#pragma once

#include "editor/document/Edit.h"

#include <QList>
#include <QObject>

#include <memory>
#include <span>
#include <vector>

class QAction;

namespace rubble {

class Views;
class Workspace;
struct ActionDefinition;
struct Bake;

/// Hides, isolates and shows fragments of the active asset, or instances. H and Shift+H belong to what is the subject
/// of the selection; Alt+H shows all that the view with the focus can hide: fragments, and in the 3D view instances.
class VisibilityActions : public QObject {
    Q_OBJECT
public:
    explicit VisibilityActions(Views& views);

    /// Hide, isolate and show all, in this order.
    QList<QAction*> fragmentActions() const { return {m_hideFragments, m_isolateFragments, m_showFragments}; }
    QList<QAction*> instanceActions() const { return {m_hideInstances, m_isolateInstances, m_showInstances}; }

private:
    using InstanceEdit = Edit (*)(const Project&, std::span<const Id> instances);

    void addFragmentActions();
    void addInstanceActions();
    void addShowAllKey();
    QAction* add(const ActionDefinition& definition, void (VisibilityActions::*slot)());
    QAction* addEdit(const ActionDefinition& definition, InstanceEdit edit);
    void hideFragments();
    void isolateFragments();
    void showFragments();
    void showInstances();
    void updateEnabled();
    /// The selected instances, if they are the subject.
    std::vector<Id> instances() const;
    /// The bake of the active asset, or null if there is none.
    std::shared_ptr<const Bake> bake() const;

    Views& m_views;
    Workspace& m_workspace;
    QAction* m_hideFragments = nullptr;
    QAction* m_isolateFragments = nullptr;
    QAction* m_showFragments = nullptr;
    QAction* m_hideInstances = nullptr;
    QAction* m_isolateInstances = nullptr;
    QAction* m_showInstances = nullptr;
    QAction* m_showAllKey = nullptr;  // in the 3D view
};

}  // namespace rubble
