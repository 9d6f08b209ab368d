#include "editor/EditActions.h"

#include "core/fracture/SeedEdits.h"
#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/PreferencesDialog.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/icons/Icon.h"

#include <QMenu>

namespace rubble {

namespace {

/// The seeds of the asset at hand, as far as its pattern was made.
Selection::Seeds allSeeds(Workspace& workspace) {
    const auto pattern = workspace.bakes().findPattern(workspace.selection().asset());
    if (!pattern) return {};
    return {pattern->seeds.ids.begin(), pattern->seeds.ids.end()};
}

/// The chosen seeds and those whose cells touch theirs.
Selection::Seeds withNeighbours(Workspace& workspace) {
    Selection::Seeds chosen = workspace.selection().seeds();
    const auto pattern = workspace.bakes().findPattern(workspace.selection().asset());
    if (!pattern) return chosen;
    const std::vector<SeedId>& ids = pattern->seeds.ids;
    const Partition& partition = pattern->partition;
    const Selection::Seeds before = chosen;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (!before.contains(ids[partition.seedOfPiece[piece]])) continue;
        for (const PieceContact& contact : contactsOf(partition, piece, 0.0)) {
            chosen.insert(ids[partition.seedOfPiece[contact.piece]]);
        }
    }
    return chosen;
}

}  // namespace

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
    add({"select-all", tr("Select &All"), tr("Choose all seeds of the asset"), QKeySequence("Ctrl+A")},
        &EditActions::chooseAll);
    add({"select-none", tr("Select &None"), tr("Choose no seed"), QKeySequence("Ctrl+Shift+A")},
        &EditActions::chooseNone);
    add({"select-invert", tr("&Invert Selection"), tr("Choose the seeds that are not chosen"),
         QKeySequence("Ctrl+Shift+I")},
        &EditActions::invert);
    QAction* neighbours = add({"select-neighbours", tr("Select Nei&ghbours"),
                               tr("Choose, too, whose cells touch those of the chosen seeds"), QKeySequence("Ctrl+G")},
                              &EditActions::chooseNeighbours);
    m_menu->addSeparator();
    add({"edit-preferences", tr("&Preferences…"), tr("Theme, navigation, units and backups"), QKeySequence("Ctrl+,")},
        &EditActions::openPreferences);
    m_forSeeds = {remove, neighbours};
    connect(&window.workspace().selection(), &Selection::seedsChanged, this, &EditActions::update);
    update();
}

void EditActions::deleteSeeds() {
    Workspace& workspace = m_window.workspace();
    if (!workspace.asset()) return;
    Asset asset = *workspace.asset();
    for (const SeedId seed : workspace.selection().seeds()) deleteSeed(asset.pattern, seed);
    workspace.selection().setSeeds({});
    workspace.document().push(altered(tr("Delete seeds"), std::move(asset)));
}

void EditActions::restoreSeeds() {
    Workspace& workspace = m_window.workspace();
    if (!workspace.asset()) return;
    Asset asset = *workspace.asset();
    for (PatternLayer& layer : asset.pattern.layers) layer.overrides.clear();
    workspace.document().push(altered(tr("Restore seeds"), std::move(asset)));
}

void EditActions::chooseAll() { m_window.workspace().selection().setSeeds(allSeeds(m_window.workspace())); }

void EditActions::chooseNone() { m_window.workspace().selection().setSeeds({}); }

void EditActions::invert() {
    Selection::Seeds rest = allSeeds(m_window.workspace());
    for (const SeedId seed : m_window.workspace().selection().seeds()) rest.erase(seed);
    m_window.workspace().selection().setSeeds(std::move(rest));
}

void EditActions::chooseNeighbours() {
    m_window.workspace().selection().setSeeds(withNeighbours(m_window.workspace()));
}

void EditActions::openPreferences() { PreferencesDialog(m_window.program(), &m_window).exec(); }

void EditActions::update() {
    for (QAction* action : m_forSeeds) action->setEnabled(!m_window.workspace().selection().seeds().empty());
}

}  // namespace rubble
