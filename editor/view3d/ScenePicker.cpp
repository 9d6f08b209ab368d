#include "editor/view3d/ScenePicker.h"

#include "core/asset/placement/InstancePlacement.h"
#include "editor/commands/InstanceEdits.h"
#include "viewport/widget/ViewportWidget.h"

#include <set>
#include <utility>

namespace rubble {

ScenePicker::ScenePicker(Workspace& workspace, ViewportWidget& viewport)
    : QObject(&viewport), m_workspace(workspace), m_viewport(viewport) {
    connect(&viewport, &ViewportWidget::picked, this, &ScenePicker::pick);
    connect(&viewport, &ViewportWidget::boxSelected, this, &ScenePicker::pickRectangle);
}

SceneMarks ScenePicker::marks() const {
    const Selection& selection = m_workspace.selection();
    SceneMarks marks;
    addIds(selection.fragments(), marks.selected);
    addIds(selection.hidden(), marks.hidden);
    for (const Instance& instance : m_workspace.project().instances) {
        const bool isSelected = selection.fragments().isEmpty() && selection.instances().contains(instance.id);
        if (isSelected) marks.selected.push_back({instance.asset, instance.id, kNone});
        if (instance.isHidden) marks.hidden.push_back({instance.asset, instance.id, kNone});
    }
    return marks;
}

/// Adds the ids of fragments of the active asset and of their descendants, in all instances of its base variant.
void ScenePicker::addIds(const FragmentSelection& selection, std::vector<PickId>& picks) const {
    const Id asset = m_workspace.selection().asset();
    const std::shared_ptr<const Bake> bake = activeBake();
    if (selection.isEmpty() || !bake) return;
    std::vector<Id> instances;
    bool areAll = true;
    for (const Instance& instance : m_workspace.project().instances) {
        if (instance.asset != asset) continue;
        instance.variant == 0 ? instances.push_back(instance.id) : void(areAll = false);
    }
    if (areAll || m_isAssetOnly) instances = {0};
    const FragmentSet marked = withDescendants(*bake, fragmentsOf(selection, *bake));
    for (std::uint32_t fragment = 0; fragment < marked.size(); ++fragment) {
        if (!marked[fragment]) continue;
        for (const Id instance : instances) picks.push_back({asset, instance, fragment});
    }
}

std::shared_ptr<const Bake> ScenePicker::activeBake() const {
    const auto baked = m_workspace.bakes().find(m_workspace.selection().asset());
    return baked ? baked->bake : nullptr;
}

void ScenePicker::deselectAll() {
    m_workspace.selection().setSeeds({});
    m_workspace.selection().setInstances(m_workspace.project(), {});
}

void ScenePicker::selectInstance(Id instance, bool isExtending) {
    Selection& selection = m_workspace.selection();
    std::set<Id> instances;
    if (isExtending) instances = selection.instances();
    if (!instances.insert(instance).second) instances.erase(instance);
    selection.setSeeds({});
    selection.setInstances(m_workspace.project(), std::move(instances));
}

void ScenePicker::selectInstanceAt(QPoint point) {
    const Project& project = m_workspace.project();
    const auto hit = sceneHit(project, assetHulls(project), m_viewport.rayAt(point));
    if (!hit || hit->instance == 0 || findInstance(project, hit->instance)->isLocked) return;
    if (!m_workspace.selection().instances().contains(hit->instance)) selectInstance(hit->instance, false);
}

bool ScenePicker::selectFragmentAt(QPoint point) {
    const std::optional<PickId> id = m_viewport.pickAt(point);
    if (!m_isAssetOnly && !isInSelectedFragments(id)) return false;
    const std::shared_ptr<const Bake> bake = activeBake();
    if (!id || !bake || id->fragment >= bake->fragmentCount()) return m_isAssetOnly;
    if (!fragmentsOf(m_workspace.selection().fragments(), *bake)[id->fragment]) pick(id, {});
    return true;
}

/// Whether it is in the instance whose fragments are selected.
bool ScenePicker::isInSelectedFragments(const std::optional<PickId>& id) const {
    const Selection& selection = m_workspace.selection();
    const Instance* instance = id ? findInstance(m_workspace.project(), id->instance) : nullptr;
    return instance && !instance->isLocked && instance->variant == 0 && instance->asset == selection.asset() &&
           selection.instances() == std::set<Id>{instance->id} && !selection.fragments().isEmpty();
}

/// A click selects the instance; in the only selected instance, it selects the fragment. Ctrl and Shift extend the
/// selection. Fragments of other variants cannot be selected, since the canvas shows the base variant; locked instances
/// are treated as background.
void ScenePicker::pick(const std::optional<PickId>& id, Qt::KeyboardModifiers modifiers) {
    Selection& selection = m_workspace.selection();
    const bool isExtending = modifiers.testAnyFlags(Qt::ControlModifier | Qt::ShiftModifier);
    const Instance* instance = id ? findInstance(m_workspace.project(), id->instance) : nullptr;
    if (!id || (instance && instance->isLocked)) {
        if (!isExtending) deselectAll();
        return;
    }
    if (instance && (instance->variant != 0 || selection.instances() != std::set<Id>{instance->id})) {
        return selectInstance(instance->id, isExtending);
    }
    selection.setAsset(id->asset);
    const std::shared_ptr<const Bake> bake = activeBake();
    if (!bake || id->fragment >= bake->fragmentCount()) return selection.setSeeds({});
    FragmentSet selected(bake->fragmentCount(), false);
    if (isExtending) selected = fragmentsOf(selection.fragments(), *bake);
    selected[id->fragment] = !selected[id->fragment];
    selection.setFragments(selectionOf(selected, *bake, selection.enteredFragment()));
}

/// Selects the instances in a selection rectangle, or the fragments if an asset is shown by itself.
void ScenePicker::pickRectangle(const std::vector<PickId>& ids, Qt::KeyboardModifiers modifiers) {
    Selection& selection = m_workspace.selection();
    const bool isExtending = modifiers.testAnyFlags(Qt::ControlModifier | Qt::ShiftModifier);
    if (m_isAssetOnly) return selectFragments(ids, isExtending);
    std::set<Id> instances;
    if (isExtending) instances = selection.instances();
    if (!isExtending) deselectAll();
    for (const PickId& id : ids) {
        const Instance* instance = findInstance(m_workspace.project(), id.instance);
        if (instance && !instance->isLocked) instances.insert(instance->id);
    }
    if (instances.empty()) return;
    selection.setSeeds({});
    selection.setInstances(m_workspace.project(), std::move(instances));
}

void ScenePicker::selectFragments(const std::vector<PickId>& ids, bool isExtending) {
    Selection& selection = m_workspace.selection();
    const std::shared_ptr<const Bake> bake = activeBake();
    if (!bake) return;
    FragmentSet selected(bake->fragmentCount(), false);
    if (isExtending) selected = fragmentsOf(selection.fragments(), *bake);
    for (const PickId& id : ids) {
        if (id.fragment < selected.size()) selected[id.fragment] = true;
    }
    selection.setFragments(selectionOf(selected, *bake, selection.enteredFragment()));
}

}  // namespace rubble

#include "moc_ScenePicker.cpp"
