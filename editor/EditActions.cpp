#include "editor/EditActions.h"

#include "core/fracture/PatternPartition.h"
#include "core/fracture/SeedEdits.h"
#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/PreferencesDialog.h"
#include "editor/commands/PatternPlaces.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/icons/Icon.h"

#include <QMenu>

#include <algorithm>

namespace rubble {

EditActions::EditActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&Edit"), &window)) {
    const auto add = addingTo(*m_menu, this);
    QUndoStack& stack = window.workspace().document().undoStack();
    m_undo = stack.createUndoAction(this, tr("&Undo"));
    m_redo = stack.createRedoAction(this, tr("&Redo"));
    m_undo->setObjectName("edit-undo");
    m_redo->setObjectName("edit-redo");
    m_undo->setIcon(iconNamed("edit-undo"));
    m_redo->setIcon(iconNamed("edit-redo"));
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    m_undo->setStatusTip(tr("Take the last step back"));
    m_redo->setStatusTip(tr("Do again what was taken back"));
    m_menu->addActions({m_undo, m_redo});
    m_menu->addSeparator();
    QAction* remove =
        add({"seed-delete", tr("&Delete Seeds"), tr("Delete the chosen seeds; the cells around take their place")},
            &EditActions::deleteSeeds);
    add({"seed-restore", tr("Re&store Seeds"), tr("Bring back scattered seeds that were moved or deleted")},
        &EditActions::restoreSeeds);
    m_menu->addSeparator();
    add({"edit-preferences", tr("&Preferences…"), tr("Theme, navigation, units and backups"), QKeySequence("Ctrl+,")},
        &EditActions::openPreferences);
    m_forSeeds = {remove};
    connect(&window.workspace().selection(), &Selection::seedsChanged, this, &EditActions::update);
    update();
}

void EditActions::deleteSeeds() {
    Workspace& workspace = m_window.workspace();
    if (!workspace.asset()) return;
    Asset asset = *workspace.asset();
    Pattern& pattern = ownPattern(asset, workspace.selection().inside());
    for (const SeedId seed : workspace.selection().seeds()) deleteSeed(pattern, seed);
    workspace.selection().setSeeds({});
    workspace.document().push(altered(tr("Delete seeds"), std::move(asset)));
}

void EditActions::restoreSeeds() {
    Workspace& workspace = m_window.workspace();
    if (!workspace.asset()) return;
    Asset asset = *workspace.asset();
    Pattern& pattern = ownPattern(asset, workspace.selection().inside());
    const auto hasOverrides = [](const PatternLayer& layer) { return !layer.overrides.empty(); };
    if (std::ranges::none_of(pattern.layers, hasOverrides)) return;
    for (PatternLayer& layer : pattern.layers) layer.overrides.clear();
    workspace.document().push(altered(tr("Restore seeds"), std::move(asset)));
}

void EditActions::openPreferences() { PreferencesDialog(m_window.program(), &m_window).exec(); }

void EditActions::update() {
    for (QAction* action : m_forSeeds) action->setEnabled(!m_window.workspace().selection().seeds().empty());
}

}  // namespace rubble
