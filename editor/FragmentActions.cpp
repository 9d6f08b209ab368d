#include "editor/FragmentActions.h"

#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/commands/FragmentEdits.h"

#include <QMenu>

namespace rubble {

FragmentActions::FragmentActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("F&ragments"), &window)) {
    const auto add = addingTo(*m_menu, this);
    m_forPieces = {add({"fragment-fracture", tr("&Fracture Again"),
                        tr("Break the chosen fragments once more, each in its own way"), QKeySequence("Ctrl+Shift+F")},
                       &FragmentActions::fracture),
                   add({"fragment-whole", tr("&Keep Whole"),
                        tr("Leave the chosen fragments as they are, whatever their level says")},
                       &FragmentActions::keepWhole)};
    m_menu->addSeparator();
    m_merge = add({"fragment-merge", tr("&Merge"), tr("Make the chosen fragments one, named after the largest"),
                   QKeySequence("Ctrl+M")},
                  &FragmentActions::merge);
    m_forPieces +=
        add({"fragment-split", tr("&Split"), tr("Cut each of the chosen fragments in two, across its longest way"),
             QKeySequence("Ctrl+Shift+M")},
            &FragmentActions::split);
    m_menu->addSeparator();
    m_restore = add({"fragment-restore", tr("&Restore"),
                     tr("Take back merges and splits of the chosen fragments, and how they break by themselves")},
                    &FragmentActions::restore);
    Workspace& workspace = window.workspace();
    connect(&workspace.selection(), &Selection::seedsChanged, this, &FragmentActions::update);
    connect(&workspace.selection(), &Selection::assetChanged, this, &FragmentActions::update);
    connect(&workspace.bakes(), &Bakes::patternChanged, this, &FragmentActions::update);
    connect(&workspace.document(), &Document::changed, this, &FragmentActions::update);
    update();
}

std::vector<ChosenPiece> FragmentActions::chosen() const {
    Workspace& workspace = m_window.workspace();
    const auto pattern = workspace.bakes().findPattern(workspace.selection().asset());
    if (!pattern || !workspace.asset()) return {};
    return chosenPieces(pattern->partition, pattern->seeds, workspace.selection().seeds());
}

void FragmentActions::fracture() {
    Workspace& workspace = m_window.workspace();
    const std::vector<ChosenPiece> pieces = chosen();
    if (!pieces.empty()) {
        workspace.document().push(fractureFragments(workspace.project(), workspace.selection().asset(), pieces));
    }
}

void FragmentActions::keepWhole() {
    Workspace& workspace = m_window.workspace();
    const std::vector<ChosenPiece> pieces = chosen();
    if (!pieces.empty()) {
        workspace.document().push(keepFragmentsWhole(workspace.project(), workspace.selection().asset(), pieces));
    }
}

void FragmentActions::merge() {
    Workspace& workspace = m_window.workspace();
    const std::vector<ChosenPiece> pieces = chosen();
    if (pieces.size() > 1) {
        workspace.document().push(mergeFragments(workspace.project(), workspace.selection().asset(), pieces));
    }
}

void FragmentActions::split() {
    Workspace& workspace = m_window.workspace();
    const std::vector<ChosenPiece> pieces = chosen();
    if (!pieces.empty()) {
        workspace.document().push(splitFragments(workspace.project(), workspace.selection().asset(), pieces));
    }
}

void FragmentActions::restore() {
    Workspace& workspace = m_window.workspace();
    if (!workspace.asset()) return;
    workspace.document().push(
        restoreFragments(workspace.project(), workspace.selection().asset(), workspace.selection().seeds()));
}

/// Cheap enough for every change: what is looked at is the seeds, not their pieces.
void FragmentActions::update() {
    Workspace& workspace = m_window.workspace();
    const Selection::Seeds& seeds = workspace.selection().seeds();
    const bool hasAny = workspace.asset() && !seeds.empty();
    for (QAction* action : m_forPieces) action->setEnabled(hasAny);
    m_merge->setEnabled(hasAny);
    m_restore->setEnabled(hasAny && areRestorable(*workspace.asset(), seeds));
}

}  // namespace rubble
