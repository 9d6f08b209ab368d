#include "editor/actions/SelectActions.h"

#include "editor/actions/VisibilityActions.h"
#include "editor/dialogs/SelectDialogs.h"
#include "editor/document/CellSelection.h"
#include "editor/document/FragmentSeeds.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/PreferenceStore.h"
#include "editor/workspace/Workspace.h"

#include <QMainWindow>
#include <QMenu>

#include <algorithm>

namespace rubble {

namespace {

/// The complement of a set among the fragments inside `parent`.
FragmentSet invertedInside(const FragmentPath& parent, const Bake& bake, const FragmentSet& set) {
    FragmentSet others = invertedFragments(bake, set);
    const std::vector<std::optional<SeedId>> seeds = seedsOfFragments(bake, parent);
    for (std::size_t k = 0; k < others.size(); ++k) others[k] = others[k] && seeds[k];
    return others;
}

}  // namespace

SelectActions::SelectActions(Views& views, const PreferenceStore& preferences, const VisibilityActions& visibility)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_preferences(preferences),
      m_menu(new QMenu(tr("Sele&ct"), &views.window())) {
    const auto add = actionAdder(*m_menu, this);
    add({"select-all", tr("Select &All"),
         tr("Select all seeds and fragments; where an instance is selected, all instances"), QKeySequence("Ctrl+A")},
        &SelectActions::selectAll);
    add({"select-none", tr("Select &None"), tr("Clear the selection"), QKeySequence("Ctrl+Shift+A")},
        &SelectActions::selectNone);
    add({"select-invert", tr("&Invert Selection"), tr("Invert the selection"), QKeySequence("Ctrl+Shift+I")},
        &SelectActions::invert);
    m_menu->addSeparator();
    addRelated();
    m_menu->addSeparator();
    addByValue();
    m_menu->addSeparator();
    m_menu->addActions(visibility.fragmentActions());
    Selection& selection = m_workspace.selection();
    connect(&selection, &Selection::seedsChanged, this, &SelectActions::updateEnabled);
    connect(&selection, &Selection::assetChanged, this, &SelectActions::updateLevels);
    connect(&m_workspace.bakes(), &Bakes::changed, this, &SelectActions::updateLevels);
    updateLevels();
}

void SelectActions::addRelated() {
    const auto add = actionAdder(*m_menu, this);
    m_needSelection = {add({"select-neighbours", tr("Select Nei&ghbours"),
                            tr("Add the neighbouring fragments to the selection"), QKeySequence("Ctrl+G")},
                           &SelectActions::selectNeighbours),
                       add({"select-siblings", tr("Select &Siblings"), tr("Select all fragments with the same parent"),
                            QKeySequence("Ctrl+Shift+G")},
                           &SelectActions::selectSiblings),
                       addInViews({"select-parents", tr("Select &Parents"),
                                   tr("Select the parents of the selected fragments"), QKeySequence("[")},
                                  &SelectActions::selectParents),
                       addInViews({"select-children", tr("Select &Children"),
                                   tr("Select the children of the selected fragments"), QKeySequence("]")},
                                  &SelectActions::selectChildren)};
    m_levels = m_menu->addMenu(tr("Select &Level"));
}

void SelectActions::addByValue() {
    const auto add = actionAdder(*m_menu, this);
    m_needBake = {
        add({"select-volume", tr("Select by &Volume…"), tr("Select the fragments whose volume is in a range")},
            &SelectActions::selectByVolume),
        add({"select-random", tr("Select &Randomly…"), tr("Select a random fraction of the fragments")},
            &SelectActions::selectRandomly)};
}

/// Adds an action whose shortcut works while canvas or 3D view has the focus.
QAction* SelectActions::addInViews(const ActionDefinition& definition, Slot slot) {
    QAction* action = makeAction(this, definition);
    connect(action, &QAction::triggered, this, slot);
    m_menu->addAction(action);
    m_views.limitShortcutToViews(*action);
    return action;
}

std::shared_ptr<const Bake> SelectActions::bake() const {
    const auto baked = m_workspace.bakes().find(m_workspace.selection().asset());
    return baked ? baked->bake : nullptr;
}

std::shared_ptr<const BakedPattern> SelectActions::pattern() const {
    const Selection& selection = m_workspace.selection();
    return m_workspace.bakes().findPattern(selection.asset(), selection.enteredFragment());
}

void SelectActions::selectAll() {
    Selection& selection = m_workspace.selection();
    if (areInstancesSelected()) {
        std::set<Id> instances;
        for (const Instance& instance : m_workspace.project().instances) {
            if (!instance.isHidden && !instance.isLocked) instances.insert(instance.id);
        }
        return selection.setInstances(m_workspace.project(), std::move(instances));
    }
    if (const auto shown = pattern()) selection.setSeeds(allCells(*shown));
}

void SelectActions::selectNone() {
    Selection& selection = m_workspace.selection();
    areInstancesSelected() ? selection.setInstances(m_workspace.project(), {}) : selection.setSeeds({});
}

bool SelectActions::areInstancesSelected() const {
    const Selection& selection = m_workspace.selection();
    return selection.subject() == Part::Instance && !selection.instances().empty();
}

/// Inverts by seeds, some of which may have no cell; by fragments if only some of a seed's fragments are selected.
void SelectActions::invert() {
    Selection& selection = m_workspace.selection();
    if (selection.fragments().ids) {
        const auto inverted = [&](const Bake& now, const FragmentSet& set) {
            return invertedInside(selection.enteredFragment(), now, set);
        };
        return selectBy(inverted, tr("All fragments were selected; there is nothing left to select."));
    }
    if (const auto shown = pattern()) selection.setSeeds(invertedCells(*shown, selection.seeds()));
}

void SelectActions::selectNeighbours() {
    Selection& selection = m_workspace.selection();
    if (selection.fragments().ids) return selectBy(withNeighbours, {});
    if (const auto shown = pattern()) selection.setSeeds(withNeighbourCells(*shown, selection.seeds()));
}

void SelectActions::selectSiblings() { selectBy(siblingsOf, tr("The selected seeds have no fragments.")); }

void SelectActions::selectParents() {
    selectBy(parentsOf, tr("The selected fragments are on the first level and have no parents."));
}

void SelectActions::selectChildren() {
    selectBy(childrenOf, tr("The selected fragments are not fractured and have no children."));
}

void SelectActions::selectLevel(std::uint32_t level) {
    selectBy([level](const Bake& now, const FragmentSet&) { return fragmentsOfLevel(now, level); },
             tr("Level %1 no longer exists.").arg(level));
}

void SelectActions::selectByVolume() {
    const auto baked = bake();
    if (!baked) return;
    VolumeRangeDialog dialog(*baked, {m_preferences.preferences().unit}, &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    selectBy([&](const Bake& now, const FragmentSet&) { return fragmentsOfVolume(now, dialog.min(), dialog.max()); },
             tr("No fragment has a volume in this range."));
}

void SelectActions::selectRandomly() {
    RandomFractionDialog dialog(m_percent, m_randomSeed, &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    m_percent = dialog.percent();
    m_randomSeed = dialog.randomSeed();
    selectBy([&](const Bake& now, const FragmentSet&) { return randomFragments(now, m_percent / 100.0, m_randomSeed); },
             tr("This fraction of the fragments is less than one fragment."));
}

void SelectActions::selectBy(const Mapping& mapping, const QString& sentenceIfEmpty) {
    const auto baked = bake();
    if (!baked) {
        return m_views.showStatus(tr("The fragments are not ready yet. Try again when baking has finished."));
    }
    Selection& selection = m_workspace.selection();
    const FragmentSet found = mapping(*baked, fragmentsOf(selection.fragments(), *baked));
    if (std::ranges::find(found, true) == found.end()) return m_views.showStatus(sentenceIfEmpty);
    selection.setFragments(selectionOf(found, *baked, selection.enteredFragment()));
}

void SelectActions::updateLevels() {
    m_levels->clear();
    const auto baked = bake();
    for (QAction* action : m_needBake) action->setEnabled(baked != nullptr);
    m_levels->setEnabled(baked != nullptr);
    for (std::uint32_t level = 0; baked && level < levelCount(*baked); ++level) {
        const auto count = static_cast<int>(std::ranges::count(fragmentsOfLevel(*baked, level), true));
        QAction* action = m_levels->addAction(tr("Level &%1: %n fragment(s)", nullptr, count).arg(level));
        action->setStatusTip(tr("Select the fragments of level %1").arg(level));
        connect(action, &QAction::triggered, this, [this, level] { selectLevel(level); });
    }
    updateEnabled();
}

void SelectActions::updateEnabled() {
    const Selection& selection = m_workspace.selection();
    for (QAction* action : m_needSelection) action->setEnabled(!selection.fragments().isEmpty());
}

}  // namespace rubble

#include "moc_SelectActions.cpp"
