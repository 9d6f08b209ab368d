#include "editor/actions/FragmentActions.h"

#include "editor/document/EnteredFragment.h"
#include "editor/document/ShownText.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"

#include <QMainWindow>
#include <QMenu>

#include <optional>

namespace rubble {

namespace {

/// Returns the only fragment of a set that has no ancestor in the set; none if there are several.
std::optional<std::uint32_t> singleRoot(const FragmentSet& set, const Bake& bake) {
    std::optional<std::uint32_t> root;
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!set[k]) continue;
        std::uint32_t ancestor = bake.fragment(k).parent;
        while (ancestor != kNone && !set[ancestor]) ancestor = bake.fragment(ancestor).parent;
        if (ancestor != kNone) continue;
        if (root) return std::nullopt;
        root = k;
    }
    return root;
}

}  // namespace

FragmentActions::FragmentActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_menu(new QMenu(tr("Fra&gments"), &views.window())) {
    m_fracture =
        addEdit({"fragment-fracture", tr("&Fracture Again"),
                 tr("Fracture the selected fragments, each with its own pattern"), QKeySequence("Ctrl+Shift+F")},
                fractureFragments);
    m_keepWhole =
        addEdit({"fragment-whole", tr("&Keep Whole"), tr("Exclude the selected fragments from deeper levels")},
                keepFragmentsWhole);
    m_menu->addSeparator();
    m_merge =
        addEdit({"fragment-merge", tr("&Merge"), tr("Merge the selected fragments into one"), QKeySequence("Ctrl+M")},
                mergeFragments, 2);
    m_split = addEdit({"fragment-split", tr("&Split"), tr("Split each selected fragment in two across its length"),
                       QKeySequence("Ctrl+Shift+M")},
                      splitFragments);
    m_menu->addSeparator();
    const auto add = actionAdder(*m_menu, this);
    m_restore = add(
        {"fragment-restore", tr("&Restore"), tr("Remove the merges, splits and patterns of the selected fragments")},
        &FragmentActions::restore);
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

QAction* FragmentActions::addEdit(const ActionDefinition& definition, FragmentEdit edit, std::size_t minCount) {
    QAction* action = makeAction(this, definition);
    connect(action, &QAction::triggered, this, [this, edit, minCount] {
        const std::vector<SelectedPiece> fragments = selectedFragments();
        if (fragments.size() < minCount) return;
        m_workspace.document().push(edit(m_workspace.project(), m_workspace.selection().asset(), fragments));
    });
    m_menu->addAction(action);
    return action;
}

std::vector<SelectedPiece> FragmentActions::selectedFragments() const {
    const Selection& selection = m_workspace.selection();
    const auto pattern = m_workspace.bakes().findPattern(selection.asset(), selection.enteredFragment());
    if (!pattern || !m_workspace.asset()) return {};
    return selectedPieces(pattern->partition, pattern->seeds, selection.seeds(), pattern->parent, pattern->offset);
}

void FragmentActions::restore() {
    if (!m_workspace.asset()) return;
    const Selection& selection = m_workspace.selection();
    m_workspace.document().push(
        restoreFragments(m_workspace.project(), selection.asset(), selection.seeds(), selection.enteredFragment()));
}

/// Enters the selected fragment, or its parent if the selected one is not fractured itself.
void FragmentActions::enterSelected() {
    Selection& selection = m_workspace.selection();
    const auto baked = m_workspace.bakes().find(selection.asset());
    if (!m_workspace.asset() || !baked || !baked->bake) {
        return m_views.showStatus(tr("The fragments are not ready yet. Try again when baking has finished."));
    }
    const Bake& bake = *baked->bake;
    const FragmentSet set = fragmentsOf(selection.fragments(), bake);
    const std::optional<std::uint32_t> root = singleRoot(set, bake);
    if (!root) return m_views.showStatus(tr("Several fragments are selected. Select one to enter it."));
    const FragmentPath path = pathOfId(bake.fragmentId(*root));
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
