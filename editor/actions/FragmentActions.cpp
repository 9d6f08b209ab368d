#include "editor/actions/FragmentActions.h"

#include "editor/actions/ClusterActions.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/document/EnteredFragment.h"
#include "editor/document/ShownText.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"

#include <QMainWindow>
#include <QMenu>

#include <algorithm>
#include <iterator>
#include <optional>

namespace rubble {

namespace {

bool haveOneParent(const std::vector<SelectedFragment>& fragments) {
    return std::ranges::all_of(fragments, [&](const SelectedFragment& fragment) {
        return parentOf(fragment.path) == parentOf(fragments.front().path);
    });
}

}  // namespace

FragmentActions::FragmentActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_menu(new QMenu(tr("Fra&gments"), &views.window())) {
    m_fracture = makeAction(
        this, {"fragment-fracture", tr("&Fracture Again"),
               tr("Fracture the selected fragments, each with its own pattern"), QKeySequence("Ctrl+Shift+F")});
    connect(m_fracture, &QAction::triggered, this, &FragmentActions::fractureSelected);
    m_menu->addAction(m_fracture);
    m_keepWhole =
        addEdit({"fragment-whole", tr("&Keep Intact"), tr("Exclude the selected fragments from deeper levels")},
                keepFragmentsWhole);
    m_menu->addSeparator();
    m_merge = makeAction(
        this, {"fragment-merge", tr("&Merge"), tr("Merge the selected fragments into one"), QKeySequence("Ctrl+M")});
    connect(m_merge, &QAction::triggered, this, &FragmentActions::mergeSelected);
    m_menu->addAction(m_merge);
    m_split = addEdit({"fragment-split", tr("&Split"), tr("Split each selected fragment in two across its length"),
                       QKeySequence("Ctrl+Shift+M")},
                      splitFragments);
    m_menu->addSeparator();
    const auto add = actionAdder(*m_menu, this);
    m_restore = add(
        {"fragment-restore", tr("&Restore"), tr("Remove the merges, splits and patterns of the selected fragments")},
        &FragmentActions::restore);
    m_clusters = m_menu->addMenu((new ClusterActions(views))->menu());
    m_menu->addSeparator();
    m_enter = add({"fragment-enter", tr("&Enter Fragment"),
                   tr("Edit the pattern of the selected fragment in the canvas"), QKeySequence("Ctrl+Down")},
                  &FragmentActions::enterSelected);
    m_exit = add({"fragment-exit", tr("E&xit Fragment"), tr("Return to the pattern of the parent fragment"),
                  QKeySequence("Ctrl+Up")},
                 &FragmentActions::exitFragment);
    for (QAction* action : navigationActions()) views.limitShortcutToViews(*action);
    Selection& selection = m_workspace.selection();
    connect(&selection, &Selection::enteredFragmentChanged, this, &FragmentActions::updateEnabled);
    connect(&selection, &Selection::seedsChanged, this, &FragmentActions::updateEnabled);
    connect(&selection, &Selection::assetChanged, this, &FragmentActions::updateEnabled);
    connect(&m_workspace.bakes(), &Bakes::patternChanged, this, &FragmentActions::updateEnabled);
    connect(&m_workspace.document(), &Document::changed, this, &FragmentActions::updateEnabled);
    updateEnabled();
}

QAction* FragmentActions::addEdit(const ActionDefinition& definition, FragmentEdit edit) {
    QAction* action = makeAction(this, definition);
    connect(action, &QAction::triggered, this, [this, edit] {
        const std::vector<SelectedFragment> fragments = selectedFragments();
        if (!fragments.empty()) push(edit, fragments);
    });
    m_menu->addAction(action);
    return action;
}

bool FragmentActions::push(FragmentEdit edit, const std::vector<SelectedFragment>& fragments) {
    return m_workspace.document().push(edit(m_workspace.project(), m_workspace.selection().asset(), fragments));
}

/// Shows the result in the canvas, which draws the edges of deeper levels only if it is told to.
void FragmentActions::fractureSelected() {
    const std::vector<SelectedFragment> fragments = selectedFragments();
    if (fragments.empty() || !push(fractureFragments, fragments)) return;
    CanvasOverlays overlays = m_views.canvas().overlays();
    overlays.hasDeeperLevels = true;
    m_views.canvas().setOverlays(overlays);
    m_views.showStatus(
        tr("%Ln fragment(s) fractured · Double-click one, or select it and press %1, to edit its pattern", nullptr,
           static_cast<int>(fragments.size()))
            .arg(m_enter->shortcut().toString(QKeySequence::NativeText)));
}

void FragmentActions::mergeSelected() {
    const std::vector<SelectedFragment> fragments = selectedFragments();
    if (fragments.size() < 2) return m_views.showStatus(tr("One fragment is selected. Select others to merge with."));
    if (!haveOneParent(fragments))
        return m_views.showStatus(tr("The selected fragments have different parents. Select fragments of one parent."));
    push(mergeFragments, fragments);
}

std::vector<SelectedFragment> FragmentActions::selectedFragments() const {
    const Selection& selection = m_workspace.selection();
    const auto pattern = m_workspace.bakes().findPattern(selection.asset(), selection.enteredFragment());
    if (!pattern || !m_workspace.asset()) return {};
    const auto baked = m_workspace.bakes().find(selection.asset());
    if (pattern->section) {  // not all fragments are in it
        if (!baked || !baked->bake) return {};
        return rubble::selectedFragments(*baked->bake, selection.fragments(), pattern->parent);
    }
    std::vector<SelectedFragment> fragments = rubble::selectedFragments(
        selection.asset(), pattern->partition, pattern->seeds, selection.fragments(), pattern->parent, pattern->offset);
    if (baked && baked->bake && selection.fragments().ids) {
        std::vector<SelectedFragment> deeper =
            selectedDescendants(*baked->bake, selection.fragments(), pattern->parent);
        std::ranges::move(deeper, std::back_inserter(fragments));
    }
    return fragments;
}

void FragmentActions::restore() {
    if (!m_workspace.asset()) return;
    const Selection& selection = m_workspace.selection();
    m_workspace.document().push(
        restoreFragments(m_workspace.project(), selection.asset(), selection.seeds(), selection.enteredFragment()));
}

QString FragmentActions::severalSelectedText() const {
    return tr("Several fragments are selected. To enter one, double-click it in the canvas, or select it alone and "
              "press %1.")
        .arg(m_enter->shortcut().toString(QKeySequence::NativeText));
}

/// Enters the selected fragment, or its parent if the selected one is not fractured itself. Of several, the one that is
/// fractured.
void FragmentActions::enterSelected() {
    Selection& selection = m_workspace.selection();
    const auto baked = m_workspace.bakes().find(selection.asset());
    if (!m_workspace.asset() || !baked || !baked->bake) {
        return m_views.showStatus(tr("The fragments are not ready yet. Try again when baking has finished."));
    }
    const Bake& bake = *baked->bake;
    const FragmentSet set = fragmentsOf(selection.fragments(), bake);
    std::vector<std::uint32_t> roots = rootsOf(bake, set);
    const auto pathTo = [&](std::uint32_t fragment) { return bake.fragmentPath(fragment); };
    if (roots.size() > 1) {
        std::erase_if(roots, [&](std::uint32_t root) {
            return nearestFractured(*m_workspace.asset(), &bake, pathTo(root)) != pathTo(root);
        });
    }
    if (roots.size() != 1) return m_views.showStatus(severalSelectedText());
    const FragmentPath path = pathTo(roots.front());
    const FragmentPath fractured = nearestFractured(*m_workspace.asset(), &bake, path);
    if (fractured == path) return enterFragment(selection, path);
    if (fractured.empty() || fractured == selection.enteredFragment()) {
        return m_views.showStatus(tr("Fragment %1 is not fractured. Use Fracture Again (%2) to give it a pattern.")
                                      .arg(nameText(path), m_fracture->shortcut().toString(QKeySequence::NativeText)));
    }
    enterFragment(selection, fractured);
    selection.setFragments(selectionOf(set, bake, fractured));
}

void FragmentActions::exitFragment() {
    Selection& selection = m_workspace.selection();
    exitToFragment(selection, parentOf(selection.enteredFragment()));
}

/// Reads the selected seeds only, not their fragments: it runs on every change.
void FragmentActions::updateEnabled() {
    const Selection& selection = m_workspace.selection();
    const Asset* asset = m_workspace.asset();
    const bool hasSeeds = asset && !selection.seeds().empty();
    m_enter->setEnabled(asset && !selection.fragments().isEmpty());
    m_exit->setEnabled(!selection.enteredFragment().empty());
    for (QAction* action : {m_fracture, m_keepWhole, m_merge, m_split}) action->setEnabled(hasSeeds);
    m_restore->setEnabled(hasSeeds && canRestoreFragments(*asset, selection.seeds(), selection.enteredFragment()));
}

}  // namespace rubble

#include "moc_FragmentActions.cpp"
