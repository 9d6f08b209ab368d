#include "editor/FragmentActions.h"

#include "editor/Action.h"
#include "editor/MainWindow.h"
#include "editor/Views.h"
#include "editor/commands/FragmentEdits.h"
#include "editor/document/Inside.h"

#include <QMenu>

#include <optional>

namespace rubble {

namespace {

/// The one fragment of a set that is no piece of another one in it; none where there are several.
std::optional<std::uint32_t> onlyTopOf(const FragmentSet& set, const Bake& bake) {
    std::optional<std::uint32_t> top;
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!set[k]) continue;
        std::uint32_t above = bake.fragment(k).parent;
        while (above != kNone && !set[above]) above = bake.fragment(above).parent;
        if (above != kNone) continue;
        if (top) return std::nullopt;
        top = k;
    }
    return top;
}

}  // namespace

FragmentActions::FragmentActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("Fra&gments"), &window)) {
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
    m_menu->addSeparator();
    m_into = add(
        {"fragment-into", tr("Go &Into"),
         tr("Show and edit, in the canvas, the pattern that breaks the chosen fragment"), QKeySequence("Ctrl+Down")},
        &FragmentActions::goIntoChosen);
    m_out =
        add({"fragment-out", tr("Go &Out"),
             tr("Show, in the canvas, what the fragment that it is inside was broken out of"), QKeySequence("Ctrl+Up")},
            &FragmentActions::goOutOfIt);
    for (QAction* action : placeActions()) window.views().keyInViews(*action);
    Workspace& workspace = window.workspace();
    connect(&workspace.selection(), &Selection::insideChanged, this, &FragmentActions::update);
    connect(&workspace.selection(), &Selection::seedsChanged, this, &FragmentActions::update);
    connect(&workspace.selection(), &Selection::assetChanged, this, &FragmentActions::update);
    connect(&workspace.bakes(), &Bakes::patternChanged, this, &FragmentActions::update);
    connect(&workspace.document(), &Document::changed, this, &FragmentActions::update);
    update();
}

QList<QAction*> FragmentActions::breakingActions() const {
    return m_forPieces.first(2) + QList{m_merge, m_forPieces.last(), m_restore};
}

std::vector<ChosenPiece> FragmentActions::chosen() const {
    Workspace& workspace = m_window.workspace();
    const Selection& selection = workspace.selection();
    const auto pattern = workspace.bakes().findPattern(selection.asset(), selection.inside());
    if (!pattern || !workspace.asset()) return {};
    return chosenPieces(pattern->partition, pattern->seeds, selection.seeds(), pattern->inside, pattern->offset);
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
    workspace.document().push(restoreFragments(workspace.project(), workspace.selection().asset(),
                                               workspace.selection().seeds(), workspace.selection().inside()));
}

/// Into the chosen fragment, or into what it is a piece of where it is not broken again itself.
void FragmentActions::goIntoChosen() {
    Workspace& workspace = m_window.workspace();
    Selection& selection = workspace.selection();
    const auto baked = workspace.bakes().find(selection.asset());
    if (!workspace.asset() || !baked || !baked->bake) return m_window.say(tr("The pieces are still being made."));
    const Bake& bake = *baked->bake;
    const FragmentSet set = fragmentsOf(selection.choice(), bake);
    const std::optional<std::uint32_t> top = onlyTopOf(set, bake);
    if (!top) return m_window.say(tr("Choose one fragment to go into it."));
    const FragmentPath path = pathOfId(bake.fragmentId(*top));
    const FragmentPath broken = nearestBroken(*workspace.asset(), &bake, path);
    if (broken == path) return goInto(selection, path);
    if (broken.empty() || broken == selection.inside()) {
        return m_window.say(
            tr("Fragment %1 is not broken again. Fracture Again (%2) gives it a pattern of its own.")
                .arg(QString::fromStdString(path), m_forPieces.front()->shortcut().toString(QKeySequence::NativeText)));
    }
    goInto(selection, broken);
    selection.setChoice(choiceOf(set, bake, broken));
}

void FragmentActions::goOutOfIt() {
    Selection& selection = m_window.workspace().selection();
    goOut(selection, parentOf(selection.inside()));
}

/// Cheap enough for every change: what is looked at is the seeds, not their pieces.
void FragmentActions::update() {
    Workspace& workspace = m_window.workspace();
    const Selection::Seeds& seeds = workspace.selection().seeds();
    const bool hasAny = workspace.asset() && !seeds.empty();
    m_into->setEnabled(workspace.asset() && !workspace.selection().choice().isEmpty());
    m_out->setEnabled(!workspace.selection().inside().empty());
    for (QAction* action : m_forPieces) action->setEnabled(hasAny);
    m_merge->setEnabled(hasAny);
    m_restore->setEnabled(hasAny && areRestorable(*workspace.asset(), seeds, workspace.selection().inside()));
}

}  // namespace rubble
