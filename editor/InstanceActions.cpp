#include "editor/InstanceActions.h"

#include "editor/Action.h"
#include "editor/ArrayDialogs.h"
#include "editor/InstanceGizmo.h"
#include "editor/InstancePlacing.h"
#include "editor/MainWindow.h"
#include "editor/SceneView.h"
#include "editor/Views.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/icons/Icon.h"
#include "viewport/ViewportWidget.h"

#include <QActionGroup>
#include <QKeyEvent>

namespace rubble {

InstanceActions::InstanceActions(MainWindow& window)
    : QObject(&window), m_window(window), m_menu(new QMenu(tr("&Instance"), &window)) {
    addPlacing();
    m_menu->addSeparator();
    addTools();
    m_menu->addSeparator();
    addCopies();
    m_menu->addSeparator();
    addMarks();
    m_menu->addSeparator();
    QAction* remove = add({"instance-delete", tr("De&lete"),
                           tr("Delete the chosen instances, and what is expected of them"), QKeySequence("Delete")},
                          &InstanceActions::remove);
    remove->setShortcuts({QKeySequence("Delete"), QKeySequence("X")});
    m_forChosen.append(remove);
    addContextMenus();
    window.views().scene().viewport().installEventFilter(this);
    Workspace& workspace = window.workspace();
    connect(&workspace.selection(), &Selection::instancesChanged, this, &InstanceActions::update);
    connect(&workspace.selection(), &Selection::subjectChanged, this, &InstanceActions::update);
    connect(&workspace.document(), &Document::changed, this, &InstanceActions::update);
    update();
}

/// An action whose key counts where the 3D view has the focus.
QAction* InstanceActions::add(const ActionLook& look, void (InstanceActions::*slot)()) {
    QAction* action = makeAction(this, look);
    action->setShortcutContext(Qt::WidgetShortcut);
    if (slot != nullptr) connect(action, &QAction::triggered, this, slot);
    m_menu->addAction(action);
    m_window.views().scene().viewport().addAction(action);
    return action;
}

QAction* InstanceActions::addMode(const ActionLook& look) {
    QAction* action = add(look, nullptr);
    action->setCheckable(true);
    return action;
}

void InstanceActions::addPlacing() {
    m_place = add({"instance-place", tr("&Place by Clicks…"),
                   tr("An asset follows the pointer over ground and faces; each click places one, Esc ends"),
                   QKeySequence("Shift+A")},
                  &InstanceActions::choosePlaced);
}

void InstanceActions::addTools() {
    m_forMovable = {add({"instance-move", tr("&Move"), tr("The pointer moves the chosen instances, until a click"),
                         QKeySequence("G")},
                        &InstanceActions::move),
                    add({"instance-turn", tr("&Turn"), tr("The pointer turns the chosen instances, until a click"),
                         QKeySequence("R")},
                        &InstanceActions::turn)};
    auto* modes = new QActionGroup(this);
    QAction* arrows = addMode({"instance-arrows", tr("Handles for M&oving"),
                               tr("Show arrows by which instances are moved"), QKeySequence("W")});
    QAction* rings = addMode({"instance-rings", tr("Handles for Tu&rning"),
                              tr("Show rings by which instances are turned"), QKeySequence("E")});
    for (QAction* mode : {arrows, rings}) modes->addAction(mode);
    arrows->setChecked(true);
    connect(arrows, &QAction::triggered, this, [this] { gizmo().setMode(GizmoMode::Move); });
    connect(rings, &QAction::triggered, this, [this] { gizmo().setMode(GizmoMode::Turn); });
    connect(&gizmo(), &InstanceGizmo::modeChanged, this,
            [arrows, rings](GizmoMode mode) { (mode == GizmoMode::Move ? arrows : rings)->setChecked(true); });
    m_forMovable.append(
        add({"instance-drop", tr("Place on &Ground"),
             tr("Let the chosen instances down onto what is below them, or lift them out of it"), QKeySequence("End")},
            &InstanceActions::drop));
}

void InstanceActions::addCopies() {
    m_forChosen +=
        {add({"instance-duplicate", tr("&Duplicate"), tr("Copy the chosen instances; the pointer moves the copies"),
              QKeySequence("Shift+D")},
             &InstanceActions::duplicate),
         add({"instance-rows", tr("&Array in Rows…"), tr("Copy the chosen instances in rows, columns and storeys")},
             &InstanceActions::arrayInRows),
         add({"instance-ring", tr("Array in a Ri&ng…"), tr("Copy the chosen instances around a vertical axis")},
             &InstanceActions::arrayInRing),
         add({"instance-variants", tr("Give &Variants"),
              tr("Let each of the chosen instances break in a way of its own: same shape, other random seeds"),
              QKeySequence("V")},
             &InstanceActions::giveVariants)};
}

void InstanceActions::addMarks() {
    m_forChosen +=
        {add({"instance-hide", tr("&Hide"), tr("Leave the chosen instances out of the 3D view; they play all the same"),
              QKeySequence("H")},
             &InstanceActions::hide),
         add({"instance-isolate", tr("Hide Oth&ers"), tr("Leave all but the chosen instances out of the 3D view"),
              QKeySequence("Shift+H")},
             &InstanceActions::isolate)};
    m_showAll = add({"instance-show", tr("&Show All"), tr("Show all hidden instances again"), QKeySequence("Alt+H")},
                    &InstanceActions::showAll);
    m_forChosen.append(
        add({"instance-lock", tr("Loc&k"), tr("Keep the chosen instances from being clicked and moved in the 3D view"),
             QKeySequence("L")},
            &InstanceActions::lock));
    m_unlockAll = add({"instance-unlock", tr("&Unlock All"), tr("Let all instances be clicked and moved again"),
                       QKeySequence("Alt+L")},
                      &InstanceActions::unlockAll);
}

void InstanceActions::addContextMenus() {
    SceneView& scene = m_window.views().scene();
    scene.viewport().setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&scene.viewport(), &QWidget::customContextMenuRequested, this, [this, &scene](const QPoint& at) {
        if (gizmo().isDragging() || m_window.workspace().play().isOn()) return;
        if (scene.choosePieceAt(at)) return void(m_window.views().pieceMenu().exec(scene.viewport().mapToGlobal(at)));
        if (!scene.isEditable()) return;
        scene.chooseAt(at);
        m_menu->exec(scene.viewport().mapToGlobal(at));
    });
    m_window.views().setInstanceActions(m_menu->actions());
}

/// Alt+H would open the Help menu: the 3D view takes it first.
bool InstanceActions::eventFilter(QObject* watched, QEvent* event) {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (!isOverride && event->type() != QEvent::KeyPress) return QObject::eventFilter(watched, event);
    const QKeySequence key(static_cast<QKeyEvent*>(event)->keyCombination());
    if (key != m_showAll->shortcut() || gizmo().isDragging()) return false;
    event->accept();
    if (!isOverride) m_showAll->trigger();
    return true;
}

std::vector<Id> InstanceActions::chosen() const {
    const Selection& selection = m_window.workspace().selection();
    if (selection.subject() != Part::Instance) return {};
    return {selection.instances().begin(), selection.instances().end()};
}

InstanceGizmo& InstanceActions::gizmo() const { return m_window.views().scene().gizmo(); }

/// Asks which asset where there are several.
void InstanceActions::choosePlaced() {
    const std::vector<Asset>& assets = m_window.workspace().project().assets;
    if (assets.size() == 1) return place(assets.front().id);
    auto* menu = new QMenu(&m_window);
    menu->setObjectName("placed-assets");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (const Asset& asset : assets) {
        QAction* action = menu->addAction(iconNamed("asset"), QString::fromStdString(asset.name));
        connect(action, &QAction::triggered, this, [this, id = asset.id] { place(id); });
    }
    menu->popup(QCursor::pos());
}

void InstanceActions::place(Id asset) {
    m_window.views().showScene(true);
    m_window.views().scene().showWholeScene();
    m_window.views().scene().placing().begin(asset);
}

void InstanceActions::move() {
    gizmo().beginMoving();
    m_window.views().scene().setFocus();
}

void InstanceActions::turn() {
    gizmo().beginTurning();
    m_window.views().scene().setFocus();
}

void InstanceActions::drop() {
    Workspace& workspace = m_window.workspace();
    Edit edit = dropInstances(workspace.project(), gizmo().movable());
    if (edit.isEmpty()) return m_window.say(tr("They rest on something already, or there is nothing below them."));
    workspace.document().push(std::move(edit));
}

/// Chooses the instances that were added from an id on.
void InstanceActions::chooseSince(Id first, bool haveVariants) {
    Workspace& workspace = m_window.workspace();
    std::set<Id> added;
    for (const Instance& instance : workspace.project().instances) {
        if (instance.id >= first) added.insert(instance.id);
    }
    if (haveVariants) {
        workspace.document().push(spreadVariants(workspace.project(), std::vector<Id>(added.begin(), added.end())));
    }
    workspace.selection().setInstances(workspace.project(), std::move(added));
}

void InstanceActions::duplicate() {
    Workspace& workspace = m_window.workspace();
    const Id first = workspace.project().nextId;
    workspace.document().push(duplicateInstances(workspace.project(), chosen(), Vec3(0.0)));
    chooseSince(first, false);
    move();
}

void InstanceActions::arrayInRows() {
    Workspace& workspace = m_window.workspace();
    GridArrayDialog dialog(sizeOf(workspace.project(), chosen()), &m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    const Id first = workspace.project().nextId;
    workspace.document().undoStack().beginMacro(tr("Array in rows"));
    workspace.document().push(gridOf(workspace.project(), chosen(), dialog.array()));
    chooseSince(first, dialog.haveVariants());
    workspace.document().undoStack().endMacro();
}

void InstanceActions::arrayInRing() {
    Workspace& workspace = m_window.workspace();
    RingArrayDialog dialog(&m_window);
    if (dialog.exec() != QDialog::Accepted) return;
    const Id first = workspace.project().nextId;
    workspace.document().undoStack().beginMacro(tr("Array in a ring"));
    workspace.document().push(ringOf(workspace.project(), chosen(), dialog.array()));
    chooseSince(first, dialog.haveVariants());
    workspace.document().undoStack().endMacro();
}

void InstanceActions::giveVariants() {
    m_window.workspace().document().push(spreadVariants(m_window.workspace().project(), chosen()));
}

void InstanceActions::hide() {
    m_window.workspace().document().push(hideInstances(m_window.workspace().project(), chosen()));
}

void InstanceActions::isolate() {
    m_window.workspace().document().push(isolateInstances(m_window.workspace().project(), chosen()));
}

void InstanceActions::showAll() {
    m_window.workspace().document().push(showAllInstances(m_window.workspace().project()));
}

void InstanceActions::lock() {
    m_window.workspace().document().push(lockInstances(m_window.workspace().project(), chosen()));
}

void InstanceActions::unlockAll() {
    m_window.workspace().document().push(unlockAllInstances(m_window.workspace().project()));
}

void InstanceActions::remove() {
    m_window.workspace().document().push(removeInstances(m_window.workspace().project(), chosen()));
}

void InstanceActions::update() {
    const std::vector<Instance>& all = m_window.workspace().project().instances;
    for (QAction* action : m_forChosen) action->setEnabled(!chosen().empty());
    for (QAction* action : m_forMovable) action->setEnabled(!gizmo().movable().empty());
    m_place->setEnabled(!m_window.workspace().project().assets.empty());
    m_showAll->setEnabled(std::ranges::any_of(all, &Instance::isHidden));
    m_unlockAll->setEnabled(std::ranges::any_of(all, &Instance::isLocked));
}

}  // namespace rubble
