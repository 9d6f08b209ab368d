#include "editor/actions/EditActions.h"

#include "editor/commands/SelectedSeedEdits.h"
#include "editor/dialogs/PreferencesDialog.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Icon.h"
#include "editor/workspace/Workspace.h"

#include <QMainWindow>
#include <QMenu>

namespace rubble {

EditActions::EditActions(Views& views, PreferenceStore& preferences)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_preferences(preferences),
      m_menu(new QMenu(tr("&Edit"), &views.window())) {
    const auto add = actionAdder(*m_menu, this);
    QUndoStack& stack = m_workspace.document().undoStack();
    m_undo = stack.createUndoAction(this, tr("&Undo"));
    m_redo = stack.createRedoAction(this, tr("&Redo"));
    m_undo->setObjectName("edit-undo");
    m_redo->setObjectName("edit-redo");
    m_undo->setIcon(iconNamed("edit-undo"));
    m_redo->setIcon(iconNamed("edit-redo"));
    m_undo->setShortcut(QKeySequence::Undo);
    m_redo->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    m_undo->setStatusTip(tr("Undo the last change"));
    m_redo->setStatusTip(tr("Redo the last undone change"));
    m_menu->addActions({m_undo, m_redo});
    m_menu->addSeparator();
    m_deleteSeeds =
        add({"seed-delete", tr("&Delete Seeds"), tr("Delete the selected seeds")}, &EditActions::deleteSeeds);
    add({"seed-restore", tr("Re&store Seeds"),
         tr("Restore the selected moved seeds; without a selection, all moved and deleted seeds")},
        &EditActions::restoreSeeds);
    m_menu->addSeparator();
    add({"edit-preferences", tr("&Preferences…"), tr("Edit the preferences"), QKeySequence("Ctrl+,")},
        &EditActions::openPreferences);
    connect(&m_workspace.selection(), &Selection::seedsChanged, this, &EditActions::updateEnabled);
    updateEnabled();
}

void EditActions::deleteSeeds() {
    Selection& selection = m_workspace.selection();
    const FragmentPath& parent = selection.enteredFragment();
    const auto pattern = m_workspace.bakes().findPattern(selection.asset(), parent);
    if (!m_workspace.asset() || !pattern) return;
    Edit edit = rubble::deleteSeeds(*m_workspace.asset(), parent, seedsAmong(*pattern, selection.seeds()));
    if (edit.isEmpty()) return;
    selection.setSeeds({});
    m_workspace.document().push(std::move(edit));
}

void EditActions::restoreSeeds() {
    if (!m_workspace.asset()) return;
    const Selection& selection = m_workspace.selection();
    Edit edit = rubble::restoreSeeds(*m_workspace.asset(), selection.enteredFragment(), selection.seeds());
    if (!edit.isEmpty()) m_workspace.document().push(std::move(edit));
}

void EditActions::openPreferences() { PreferencesDialog(m_preferences, &m_views.window()).exec(); }

void EditActions::updateEnabled() { m_deleteSeeds->setEnabled(!m_workspace.selection().seeds().empty()); }

}  // namespace rubble

#include "moc_EditActions.cpp"
