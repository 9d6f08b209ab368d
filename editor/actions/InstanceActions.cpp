#include "editor/actions/InstanceActions.h"

#include "editor/actions/VisibilityActions.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/dialogs/ArrayDialogs.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/ScenePicker.h"
#include "editor/view3d/SceneView.h"
#include "editor/view3d/tools/PlacementTool.h"
#include "editor/view3d/tools/TransformTool.h"
#include "editor/views/Views.h"
#include "editor/widgets/Action.h"
#include "editor/widgets/Icon.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/ViewportWidget.h"

#include <QActionGroup>
#include <QMainWindow>

namespace rubble {

InstanceActions::InstanceActions(Views& views, const VisibilityActions& visibility)
    : QObject(&views.window()),
      m_views(views),
      m_workspace(views.workspace()),
      m_menu(new QMenu(tr("&Instance"), &views.window())) {
    m_place = add({"instance-place", tr("&Place Instances…"),
                   tr("Place instances of an asset by clicking in the 3D view"), QKeySequence("Shift+A")},
                  &InstanceActions::startPlacing);
    m_menu->addSeparator();
    addTransforms();
    m_menu->addSeparator();
    addCopies();
    m_menu->addSeparator();
    addAnchors();
    m_menu->addSeparator();
    m_menu->addActions(visibility.instanceActions());
    addLocks();
    m_menu->addSeparator();
    QAction* remove =
        addEdit({"instance-delete", tr("De&lete"), tr("Delete the selected instances"), QKeySequence("Delete")},
                removeInstances);
    remove->setShortcut(QKeySequence("Delete"));
    addContextMenus();
    connect(&m_workspace.selection(), &Selection::instancesChanged, this, &InstanceActions::updateEnabled);
    connect(&m_workspace.selection(), &Selection::subjectChanged, this, &InstanceActions::updateEnabled);
    connect(&m_workspace.document(), &Document::changed, this, &InstanceActions::updateEnabled);
    updateEnabled();
}

SceneView& InstanceActions::scene() const { return m_views.scene(); }

TransformTool& InstanceActions::gizmo() const { return scene().transformTool(); }

std::vector<Id> InstanceActions::selected() const {
    const Selection& selection = m_workspace.selection();
    if (selection.subject() != Part::Instance) return {};
    return {selection.instances().begin(), selection.instances().end()};
}

QAction* InstanceActions::add(const ActionDefinition& definition) {
    QAction* action = makeAction(this, definition);
    action->setShortcutContext(Qt::WidgetShortcut);
    m_menu->addAction(action);
    scene().viewport().addAction(action);
    return action;
}

QAction* InstanceActions::add(const ActionDefinition& definition, Slot slot) {
    QAction* action = add(definition);
    connect(action, &QAction::triggered, this, slot);
    return action;
}

QAction* InstanceActions::addEdit(const ActionDefinition& definition, InstanceEdit edit) {
    QAction* action = add(definition);
    connect(action, &QAction::triggered, this,
            [this, edit] { m_workspace.document().push(edit(m_workspace.project(), selected())); });
    m_needSelection.append(action);
    return action;
}

void InstanceActions::addTransforms() {
    m_needMovable = {
        add({"instance-move", tr("&Move"), tr("Move the selected instances with the pointer"), QKeySequence("G")},
            &InstanceActions::move),
        add({"instance-rotate", tr("&Rotate"), tr("Rotate the selected instances with the pointer"), QKeySequence("R")},
            &InstanceActions::rotate)};
    addHandles();
    m_needMovable.append(add({"instance-drop", tr("Drop to &Ground"),
                              tr("Drop the selected instances onto what is below them"), QKeySequence("End")},
                             &InstanceActions::drop));
}

void InstanceActions::addHandles() {
    QAction* moving = add({"instance-move-handles", tr("M&ove Gizmo"),
                           tr("Show a gizmo that moves the selected instances"), QKeySequence("W")});
    QAction* rotating = add({"instance-rotate-handles", tr("Ro&tate Gizmo"),
                             tr("Show a gizmo that rotates the selected instances"), QKeySequence("E")});
    auto* modes = new QActionGroup(this);
    for (QAction* mode : {moving, rotating}) {
        mode->setCheckable(true);
        modes->addAction(mode);
    }
    moving->setChecked(true);
    connect(moving, &QAction::triggered, this, [this] { gizmo().setMode(GizmoMode::Move); });
    connect(rotating, &QAction::triggered, this, [this] { gizmo().setMode(GizmoMode::Rotate); });
    connect(&gizmo(), &TransformTool::modeChanged, this,
            [moving, rotating](GizmoMode mode) { (mode == GizmoMode::Move ? moving : rotating)->setChecked(true); });
}

void InstanceActions::addCopies() {
    QAction* duplicating = add({"instance-duplicate", tr("&Duplicate"),
                                tr("Duplicate the selected instances and move the copies"), QKeySequence("Shift+D")},
                               &InstanceActions::duplicate);
    QAction* inGrid =
        add({"instance-grid-array", tr("Grid &Array…"), tr("Copy the selected instances in a grid along x, y and z")},
            &InstanceActions::arrayInGrid);
    QAction* inRing =
        add({"instance-radial-array", tr("Radial Arra&y…"), tr("Copy the selected instances around a vertical axis")},
            &InstanceActions::arrayInRing);
    m_needSelection += {duplicating, inGrid, inRing};
    addEdit({"instance-variants", tr("Assign &Variants"), tr("Give each selected instance its own fracture variant"),
             QKeySequence("V")},
            assignDistinctVariants);
}

void InstanceActions::addAnchors() {
    m_anchored =
        add({"instance-anchored", tr("Anchored &Where It Touches"),
             tr("Hold the selected bonded instances where they touch the ground or a fixed instance at the start")});
    m_anchored->setCheckable(true);
    connect(m_anchored, &QAction::triggered, this, [this] {
        m_workspace.document().push(toggleAnchored(m_workspace.project(), selected()));
        updateEnabled();  // the click changed the check mark, whether or not the project changed
    });
    m_mortar = add({"instance-mortar", tr("&Join with Mortar"),
                    tr("Join the selected bonded instances where their faces lie against each other")},
                   &InstanceActions::joinWithMortar);
}

/// Shows the new mortar and its joints.
void InstanceActions::joinWithMortar() {
    const std::vector<Id> joined = bondedInstances(m_workspace.project(), selected());
    Addition addition = addMortar(m_workspace.project(), joined);
    if (!m_workspace.document().push(std::move(addition.edit))) return;
    scene().showWholeScene();
    m_workspace.selection().setMortar(addition.id);
    m_workspace.selection().setSubject(Part::Scene);
}

void InstanceActions::addLocks() {
    addEdit({"instance-lock", tr("Loc&k"), tr("Prevent selecting and moving the selected instances in the 3D view"),
             QKeySequence("L")},
            lockInstances);
    m_unlockAll = add({"instance-unlock", tr("&Unlock All"), tr("Unlock all instances"), QKeySequence("Alt+L")},
                      &InstanceActions::unlockAll);
}

void InstanceActions::addContextMenus() {
    ViewportWidget& viewport = scene().viewport();
    viewport.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&viewport, &QWidget::customContextMenuRequested, this, [this, &viewport](const QPoint& point) {
        if (gizmo().isDragging() || m_workspace.play().isInPlay() || viewport.isPresenting()) return;
        const QPoint global = viewport.mapToGlobal(point);
        if (scene().picker().selectFragmentAt(point)) return void(m_views.fragmentMenu().exec(global));
        if (!scene().isEditable()) return;
        scene().picker().selectInstanceAt(point);
        m_menu->exec(global);
    });
    m_views.setInstanceActions(m_menu->actions());
}

/// Asks which asset to place if there are several.
void InstanceActions::startPlacing() {
    const std::vector<Asset>& assets = m_workspace.project().assets;
    if (assets.size() == 1) return place(assets.front().id);
    auto* menu = new QMenu(&m_views.window());
    menu->setObjectName("assets-to-place");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const Asset& asset : assets) {
        QAction* action = menu->addAction(iconNamed("asset"), menuText(nameText(asset.name)));
        connect(action, &QAction::triggered, this, [this, id = asset.id] { place(id); });
    }
    menu->popup(QCursor::pos());
}

void InstanceActions::place(Id asset) {
    m_views.setSceneVisible(true);
    scene().showWholeScene();
    scene().placementTool().begin(asset);
}

void InstanceActions::move() {
    gizmo().startMove();
    scene().setFocus();
}

void InstanceActions::rotate() {
    gizmo().startRotation();
    scene().setFocus();
}

void InstanceActions::drop() {
    Edit edit = dropToGround(m_workspace.project(), gizmo().movable());
    if (edit.isEmpty()) {
        return m_views.showStatus(
            tr("Nothing was dropped: the instances are already at rest, or nothing is below them."));
    }
    m_workspace.document().push(std::move(edit));
}

void InstanceActions::selectAddedSince(Id first) {
    std::set<Id> added;
    for (const Instance& instance : m_workspace.project().instances) {
        if (instance.id >= first) added.insert(instance.id);
    }
    m_workspace.selection().setInstances(m_workspace.project(), std::move(added));
}

void InstanceActions::duplicate() {
    const Id first = m_workspace.project().nextId;
    if (!m_workspace.document().push(duplicateInstances(m_workspace.project(), selected(), Vec3(0.0)))) return;
    selectAddedSince(first);
    move();
}

void InstanceActions::arrayInGrid() {
    GridArrayDialog dialog(sizeOf(m_workspace.project(), selected()), m_views.units(), &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    addArray(tr("Grid Array"), rubble::arrayInGrid(m_workspace.project(), selected(), dialog.array()),
             dialog.haveVariants());
}

void InstanceActions::arrayInRing() {
    RingArrayDialog dialog(m_views.units(), &m_views.window());
    if (dialog.exec() != QDialog::Accepted) return;
    addArray(tr("Radial Array"), rubble::arrayInRing(m_workspace.project(), selected(), dialog.array()),
             dialog.haveVariants());
}

/// Pushes the copies, and their variants if wanted, as one undo step and selects them.
void InstanceActions::addArray(const QString& text, const Edit& edit, bool haveVariants) {
    Document& document = m_workspace.document();
    const Id first = m_workspace.project().nextId;
    document.pushTogether(text, [&] {
        if (!document.push(edit)) return;
        selectAddedSince(first);
        if (haveVariants) document.push(assignDistinctVariants(m_workspace.project(), selected()));
    });
}

void InstanceActions::unlockAll() { m_workspace.document().push(unlockAllInstances(m_workspace.project())); }

void InstanceActions::updateEnabled() {
    const std::vector<Instance>& all = m_workspace.project().instances;
    for (QAction* action : m_needSelection) action->setEnabled(!selected().empty());
    for (QAction* action : m_needMovable) action->setEnabled(!gizmo().movable().empty());
    m_anchored->setEnabled(!bondedInstances(m_workspace.project(), selected()).empty());
    m_mortar->setEnabled(!bondedInstances(m_workspace.project(), selected()).empty());
    m_anchored->setChecked(areAnchored(m_workspace.project(), selected()));
    m_place->setEnabled(!m_workspace.project().assets.empty());
    m_unlockAll->setEnabled(std::ranges::any_of(all, &Instance::isLocked));
}

}  // namespace rubble

#include "moc_InstanceActions.cpp"
