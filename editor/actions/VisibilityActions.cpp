#include "editor/actions/VisibilityActions.h"

#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/FragmentVisibility.h"
#include "editor/view3d/SceneView.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QMainWindow>

#include <algorithm>

namespace rubble {

namespace {

const QKeySequence kHideKey("H");
const QKeySequence kIsolateKey("Shift+H");
const QKeySequence kShowAllKey("Alt+H");

}  // namespace

VisibilityActions::VisibilityActions(Views& views)
    : QObject(&views.window()), m_views(views), m_workspace(views.workspace()) {
    addFragmentActions();
    addInstanceActions();
    addShowAllKey();
    const Selection& selection = m_workspace.selection();
    for (const auto signal : {&Selection::seedsChanged, &Selection::hiddenChanged, &Selection::instancesChanged}) {
        connect(&selection, signal, this, &VisibilityActions::updateEnabled);
    }
    connect(&selection, &Selection::assetChanged, this, &VisibilityActions::updateEnabled);
    connect(&selection, &Selection::subjectChanged, this, &VisibilityActions::updateEnabled);
    connect(&m_workspace.document(), &Document::changed, this, &VisibilityActions::updateEnabled);
    connect(&m_workspace.play(), &PlayController::stateChanged, this, &VisibilityActions::updateEnabled);
    updateEnabled();
}

QAction* VisibilityActions::add(const ActionDefinition& definition, void (VisibilityActions::*slot)()) {
    QAction* action = makeAction(this, definition);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, slot);
    return action;
}

QAction* VisibilityActions::addEdit(const ActionDefinition& definition, InstanceEdit edit) {
    QAction* action = makeAction(this, definition);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this,
            [this, edit] { m_workspace.document().push(edit(m_workspace.project(), instances())); });
    m_views.scene().viewport().addAction(action);
    return action;
}

void VisibilityActions::addFragmentActions() {
    m_hideFragments = add({"hide", tr("&Hide Fragments"), tr("Hide the selected fragments"), kHideKey},
                          &VisibilityActions::hideFragments);
    m_isolateFragments = add({"isolate", tr("Is&olate Fragments"), tr("Hide all other fragments"), kIsolateKey},
                             &VisibilityActions::isolateFragments);
    m_isolateFragments->setShortcuts({kIsolateKey, QKeySequence("/")});
    for (QAction* action : {m_hideFragments, m_isolateFragments}) m_views.limitShortcutToViews(*action);
    m_showFragments = add({"show", tr("Sho&w All Fragments"), tr("Show all hidden fragments"), kShowAllKey},
                          &VisibilityActions::showFragments);
}

void VisibilityActions::addInstanceActions() {
    m_hideInstances = addEdit(
        {"instance-hide", tr("&Hide"), tr("Hide the selected instances in the 3D view"), kHideKey}, hideInstances);
    m_isolateInstances =
        addEdit({"instance-isolate", tr("&Isolate"), tr("Hide all other instances in the 3D view"), kIsolateKey},
                isolateInstances);
    m_showInstances = add({"instance-show", tr("&Show All"), tr("Show all hidden instances"), kShowAllKey},
                          &VisibilityActions::showInstances);
}

/// Alt+H would open the Help menu: the views take the key before the window does.
void VisibilityActions::addShowAllKey() {
    m_views.canvas().setPrecedingActions({m_showFragments});
    m_showAllKey = new QAction(this);
    m_showAllKey->setShortcut(kShowAllKey);
    m_showAllKey->setShortcutContext(Qt::WidgetShortcut);
    connect(m_showAllKey, &QAction::triggered, this, [this] {
        m_showFragments->trigger();
        m_showInstances->trigger();
    });
    m_views.scene().setPrecedingActions({m_showAllKey});
}

std::vector<Id> VisibilityActions::instances() const {
    const Selection& selection = m_workspace.selection();
    if (selection.subject() != Part::Instance) return {};
    return {selection.instances().begin(), selection.instances().end()};
}

std::shared_ptr<const Bake> VisibilityActions::bake() const {
    const auto baked = m_workspace.bakes().find(m_workspace.selection().asset());
    return baked ? baked->bake : nullptr;
}

void VisibilityActions::hideFragments() {
    if (const auto baked = bake()) hideSelected(m_workspace.selection(), *baked);
}

void VisibilityActions::isolateFragments() {
    if (const auto baked = bake()) isolateSelected(m_workspace.selection(), *baked);
}

void VisibilityActions::showFragments() { showAllFragments(m_workspace.selection()); }

void VisibilityActions::showInstances() { m_workspace.document().push(showAllInstances(m_workspace.project())); }

void VisibilityActions::updateEnabled() {
    const Selection& selection = m_workspace.selection();
    const bool isOfInstances = selection.subject() == Part::Instance;
    const bool hasFragments = !isOfInstances && !selection.fragments().isEmpty();
    for (QAction* action : {m_hideFragments, m_isolateFragments}) action->setEnabled(hasFragments);
    for (QAction* action : {m_hideInstances, m_isolateInstances}) action->setEnabled(!instances().empty());
    m_showFragments->setEnabled(!selection.hidden().isEmpty());
    m_showInstances->setEnabled(std::ranges::any_of(m_workspace.project().instances, &Instance::isHidden));
    m_showAllKey->setEnabled(!m_workspace.play().isInPlay());
}

}  // namespace rubble

#include "moc_VisibilityActions.cpp"
