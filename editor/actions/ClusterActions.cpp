#include "editor/actions/ClusterActions.h"

#include "editor/dialogs/ClusterDialog.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/workspace/Workspace.h"

#include <QMainWindow>
#include <QMenu>

namespace rubble {

ClusterActions::ClusterActions(Views& views)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_menu(new QMenu(tr("&Clusters"), &views.window())) {
    m_propose = actionAdder(*m_menu, this)(
        {"cluster-propose", tr("&Propose Clusters…"), tr("Part the fragments into clusters by number or size")},
        &ClusterActions::propose);
    m_menu->addSeparator();
    add(ClusterCommand::Make, {"cluster-make", tr("&Make Cluster"), tr("Let the selected fragments come off as one")});
    add(ClusterCommand::Grow,
        {"cluster-grow", tr("&Grow Cluster"), tr("Add the neighbours that are in no cluster to the selected ones")});
    add(ClusterCommand::Merge,
        {"cluster-merge", tr("M&erge Clusters"), tr("Make one cluster of those with selected fragments")});
    add(ClusterCommand::Split,
        {"cluster-split", tr("&Split Clusters"), tr("Halve each cluster with selected fragments")});
    m_menu->addSeparator();
    add(ClusterCommand::Remove,
        {"cluster-remove", tr("&Remove from Clusters"), tr("Remove the selected fragments from their clusters")});
    Selection& selection = m_workspace.selection();
    connect(&selection, &Selection::seedsChanged, this, &ClusterActions::updateEnabled);
    connect(&selection, &Selection::assetChanged, this, &ClusterActions::updateEnabled);
    connect(&m_workspace.document(), &Document::changed, this, &ClusterActions::updateEnabled);
    m_tips[m_propose] = m_propose->statusTip();
    updateEnabled();
}

void ClusterActions::add(ClusterCommand command, const ActionDefinition& definition) {
    QAction* action = makeAction(this, definition);
    connect(action, &QAction::triggered, this, [this, command] { carryOut(command); });
    m_menu->addAction(action);
    m_actions[command] = action;
    m_tips[action] = action->statusTip();
}

void ClusterActions::propose() {
    const std::shared_ptr<const Bake> bake = readyBake();
    if (!bake) return;
    Selection& selection = m_workspace.selection();
    ClusterDialog dialog(m_target, selection.clusterLevel(), &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    m_target = dialog.target();
    selection.setClusterLevel(dialog.level());
    push(proposeClusters(*m_workspace.asset(), *bake, selection.enteredFragment(), dialog.level(), m_target));
}

void ClusterActions::carryOut(ClusterCommand command) {
    const Selection& selection = m_workspace.selection();
    if (const std::shared_ptr<const Bake> bake = readyBake())
        push(clusterEdit(*m_workspace.asset(), *bake, selection.fragments(), command, selection.clusterLevel()));
}

void ClusterActions::push(Result<Edit> edit) {
    if (!edit) return m_views.showStatus(QString::fromStdString(edit.error().message));
    m_workspace.document().push(std::move(*edit));
}

std::shared_ptr<const Bake> ClusterActions::readyBake() const {
    const auto baked = m_workspace.bakes().find(m_workspace.selection().asset());
    if (m_workspace.asset() != nullptr && baked && baked->bake) return baked->bake;
    m_views.showStatus(tr("The fragments are not ready yet. Try again when baking has finished."));
    return nullptr;
}

/// The status tip of a disabled action says why it is.
void ClusterActions::updateEnabled() {
    const Asset* asset = m_workspace.asset();
    const bool isBonded = asset != nullptr && asset->breakAs == BreakAs::Bonded;
    const bool hasSelection = !m_workspace.selection().fragments().isEmpty();
    const QString missing = !isBonded
                                ? tr("Only assets that break as bonded have clusters: see Break as in the inspector")
                                : tr("Select fragments first");
    for (const auto& [action, tip] : m_tips) {
        const bool isOn = isBonded && (hasSelection || action == m_propose);
        action->setEnabled(isOn);
        action->setStatusTip(isOn ? tip : missing);
    }
    m_menu->menuAction()->setStatusTip(isBonded ? QString() : missing);
}

}  // namespace rubble

#include "moc_ClusterActions.cpp"
