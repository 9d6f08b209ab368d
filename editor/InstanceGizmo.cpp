#include "editor/InstanceGizmo.h"

#include "core/base/Trigonometry.h"
#include "editor/commands/InstanceEdits.h"
#include "viewport/ViewportWidget.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QtMath>

#include <cmath>
#include <numbers>

namespace rubble {

namespace {

constexpr int kDecimals = 3;  // of metres beside the pointer
constexpr int kDegreeDecimals = 1;

QString axisName(int axis) { return QString(QChar('x' + axis)); }

QString signedText(double value, int decimals) {
    return (value < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) +
           QLocale().toString(std::abs(value), 'f', decimals);
}

/// "x +0.300  z −1.200 m": what the handle may change.
QString lengthsText(GizmoHandle handle, Vec3 moved) {
    QStringList parts;
    for (int axis = 0; axis < 3; ++axis) {
        const bool isHeld = axisOf(handle) && isPlane(handle) == (axis == *axisOf(handle));
        if (!isHeld) parts.append(axisName(axis) + ' ' + signedText(moved[axis], kDecimals));
    }
    return parts.join("  ") + " m";
}

Quat turnAbout(int axis, double angle) {
    Quat turn{cosine(angle / 2.0), 0.0, 0.0, 0.0};
    (axis == 0 ? turn.x : axis == 1 ? turn.y : turn.z) = sine(angle / 2.0);
    return turn;
}

/// The middle of an asset's box, in its prism's frame.
Vec3 middleOf(const Asset& asset) {
    const Box2 bounds = boundsOf(asset.prism.outline.outer);
    return {0.5 * (bounds.min + bounds.max), 0.0};
}

/// The handle that X, Y or Z holds a drag to; nothing for other keys.
std::optional<GizmoHandle> heldHandle(int key, bool isPlane, bool isTurn) {
    using enum GizmoHandle;
    switch (key) {
        case Qt::Key_X: return isTurn ? TurnX : isPlane ? MoveYz : MoveX;
        case Qt::Key_Y: return isTurn ? TurnY : isPlane ? MoveZx : MoveY;
        case Qt::Key_Z: return isTurn ? TurnZ : isPlane ? MoveXy : MoveZ;
        default: return std::nullopt;
    }
}

}  // namespace

InstanceGizmo::InstanceGizmo(Workspace& workspace, ViewportWidget& viewport)
    : QObject(&viewport), m_workspace(workspace), m_viewport(viewport), m_overlay(new GizmoOverlay(viewport)) {
    viewport.installEventFilter(this);
    connect(&workspace.document(), &Document::changed, this, [this](const Changes& changes) {
        // Undone beneath it, or gone: what was begun from is not there any more.
        if (m_drag && (changes.isStepTaken || changes.isEverything || movable() != m_drag->instances)) m_drag.reset();
        show();
    });
    connect(&workspace.selection(), &Selection::instancesChanged, this, &InstanceGizmo::show);
    connect(&workspace.selection(), &Selection::subjectChanged, this, &InstanceGizmo::show);
    show();
}

void InstanceGizmo::setOn(bool isOn) {
    if (!isOn) cancel();
    m_isOn = isOn;
    show();
}

void InstanceGizmo::setMode(GizmoMode mode) {
    if (mode == m_mode || m_drag) return;
    m_mode = mode;
    m_hot.reset();
    show();
    emit modeChanged(mode);
}

std::vector<Id> InstanceGizmo::movable() const {
    std::vector<Id> ids;
    if (!m_isOn || m_workspace.selection().subject() != Part::Instance) return ids;
    for (const Instance& instance : m_workspace.project().instances) {
        const bool isFree = !instance.isLocked && !instance.isHidden;
        if (isFree && m_workspace.selection().instances().contains(instance.id)) ids.push_back(instance.id);
    }
    return ids;
}

/// In the middle of those that may be moved.
std::optional<Vec3> InstanceGizmo::middle() const {
    const std::vector<Id> ids = movable();
    if (ids.empty()) return std::nullopt;
    Vec3 sum(0.0);
    for (const Id id : ids) {
        const Instance& instance = *findInstance(m_workspace.project(), id);
        sum += instance.pose.position +
               instance.pose.orientation * middleOf(*findAsset(m_workspace.project(), instance.asset));
    }
    return sum / static_cast<double>(ids.size());
}

void InstanceGizmo::show() {
    GizmoOverlay::Content content = m_overlay->content();
    content.middle = middle();
    content.mode = m_mode;
    content.hot = m_drag ? m_drag->handle : m_hot;
    if (m_drag) content.mode = isTurn(m_drag->handle) ? GizmoMode::Turn : GizmoMode::Move;
    content.isDragging = m_drag.has_value();
    content.label = m_drag ? m_label : QString();
    content.pointer = m_pointer;
    m_overlay->setContent(content);
}

void InstanceGizmo::begin(GizmoHandle handle, QPointF pointer) {
    const std::optional<GizmoView> view = m_overlay->view();
    if (!view) return;
    m_pointer = pointer;
    m_drag = {.handle = handle,
              .view = *view,
              .from = m_viewport.rayAt(pointer),
              .instances = movable(),
              .stroke = m_workspace.document().newStroke(),
              .hulls = assetHulls(m_workspace.project())};
    for (const Id id : m_drag->instances) m_drag->poses.push_back(findInstance(m_workspace.project(), id)->pose);
    m_label.clear();
    emit hintChanged(isTurn(handle)
                         ? tr("X, Y, Z: about this axis · Ctrl: by 15° · Esc: put back")
                         : tr("X, Y, Z: along this axis, with Shift in the plane square to it · Ctrl: by 0.1 m "
                              "· Shift: on the face under the pointer · Esc: put back"));
    show();
}

void InstanceGizmo::beginWithPointer(GizmoHandle handle) {
    if (m_drag) return;
    begin(handle, m_pointer);
    if (m_drag) m_drag->isByPointer = true;
}

void InstanceGizmo::push(const QString& text, const std::vector<Pose>& poses) {
    const Project& project = m_workspace.project();
    m_workspace.document().push(movedInstances(text, project, m_drag->instances, poses, m_drag->stroke));
}

void InstanceGizmo::follow(QPointF pointer, Qt::KeyboardModifiers modifiers) {
    m_pointer = pointer;
    isTurn(m_drag->handle) ? turn(modifiers) : move(modifiers);
    show();
}

void InstanceGizmo::move(Qt::KeyboardModifiers modifiers) {
    const bool isFree = m_drag->handle == GizmoHandle::MoveFreely;
    if (isFree && modifiers.testFlag(Qt::ShiftModifier) && layOnFace()) return;
    std::optional<Vec3> moved = movedBy(m_drag->handle, m_drag->view, m_drag->from, m_viewport.rayAt(m_pointer));
    if (!moved) return;
    for (int axis = 0; axis < 3 && modifiers.testFlag(Qt::ControlModifier); ++axis) {
        (*moved)[axis] = snapped((*moved)[axis], kStep);
    }
    std::vector<Pose> poses = m_drag->poses;
    for (Pose& pose : poses) pose.position += *moved;
    m_label = lengthsText(m_drag->handle, *moved);
    push(tr("Move"), poses);
}

/// True where one instance is moved and there is a face.
bool InstanceGizmo::layOnFace() {
    const Project& project = m_workspace.project();
    if (m_drag->instances.size() != 1) return false;
    const Instance& instance = *findInstance(project, m_drag->instances.front());
    const auto hit = sceneHit(project, m_drag->hulls, m_viewport.rayAt(m_pointer), m_drag->instances);
    if (!hit || !m_drag->hulls.contains(instance.asset)) return false;
    Pose pose = m_drag->poses.front();
    pose.position = restingPosition(m_drag->hulls.at(instance.asset), pose.orientation, *hit);
    const Instance* on = findInstance(project, hit->instance);
    m_label = on ? tr("on %1").arg(QString::fromStdString(on->name)) : tr("on the ground");
    push(tr("Move"), {pose});
    return true;
}

void InstanceGizmo::turn(Qt::KeyboardModifiers modifiers) {
    const auto angle = turnedBy(m_drag->handle, m_drag->view, m_drag->from, m_viewport.rayAt(m_pointer));
    if (!angle) return;
    // More than half a turn is told by going on the way it went.
    m_drag->turned += std::remainder(*angle - m_drag->lastAngle, 2.0 * std::numbers::pi);
    m_drag->lastAngle = *angle;
    double degrees = qRadiansToDegrees(m_drag->turned);
    if (modifiers.testFlag(Qt::ControlModifier)) degrees = snapped(degrees, kStepDegrees);
    const int axis = *axisOf(m_drag->handle);
    const Quat turn = turnAbout(axis, qDegreesToRadians(degrees));
    std::vector<Pose> poses = m_drag->poses;
    for (Pose& pose : poses) {
        pose.position = m_drag->view.middle + turn * (pose.position - m_drag->view.middle);
        pose.orientation = glm::normalize(turn * pose.orientation);
    }
    m_label = axisName(axis) + ' ' + signedText(degrees, kDegreeDecimals) + QStringLiteral("°");
    push(tr("Turn"), poses);
}

/// Takes another handle for the drag at hand, from where it began.
void InstanceGizmo::hold(GizmoHandle handle, Qt::KeyboardModifiers modifiers) {
    m_drag->handle = m_drag->handle == handle && !isTurn(handle) ? GizmoHandle::MoveFreely : handle;
    m_drag->turned = m_drag->lastAngle = 0.0;
    modifiers.setFlag(Qt::ShiftModifier, false);
    follow(m_pointer, modifiers);
}

void InstanceGizmo::cancel() {
    if (!m_drag) return;
    push(isTurn(m_drag->handle) ? tr("Turn") : tr("Move"), m_drag->poses);
    finish();
}

void InstanceGizmo::finish() {
    m_drag.reset();
    m_hot.reset();
    emit hintChanged({});
    show();
}

bool InstanceGizmo::press(const QMouseEvent& event) {
    if (m_drag && event.button() == Qt::RightButton) return cancel(), true;
    if (m_drag) {
        if (m_drag->isByPointer && event.button() == Qt::LeftButton) finish();
        return true;
    }
    const bool isPlain = event.button() == Qt::LeftButton && !event.modifiers().testFlag(Qt::AltModifier);
    const std::optional<GizmoView> view = m_overlay->view();
    if (!isPlain || !view) return false;
    const auto handle = handleAt({event.position().x(), event.position().y()}, m_mode, *view);
    if (handle) begin(*handle, event.position());
    return handle.has_value();
}

bool InstanceGizmo::point(const QMouseEvent& event) {
    if (m_drag) return follow(event.position(), event.modifiers()), true;
    m_pointer = event.position();
    const std::optional<GizmoView> view = m_overlay->view();
    std::optional<GizmoHandle> hot;
    if (view && event.buttons() == Qt::NoButton) hot = handleAt({m_pointer.x(), m_pointer.y()}, m_mode, *view);
    if (hot != m_hot) {
        m_hot = hot;
        show();
    }
    return hot.has_value();
}

/// Keys of a drag; all others wait for its end.
bool InstanceGizmo::takeKey(const QKeyEvent& event) {
    const bool isPlane = event.modifiers().testFlag(Qt::ShiftModifier);
    if (const auto handle = heldHandle(event.key(), isPlane, isTurn(m_drag->handle))) hold(*handle, event.modifiers());
    if (event.key() == Qt::Key_Escape) cancel();
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) finish();
    return true;
}

bool InstanceGizmo::eventFilter(QObject* watched, QEvent* event) {
    if (!m_isOn) return QObject::eventFilter(watched, event);
    switch (event->type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick: return press(static_cast<QMouseEvent&>(*event));
        case QEvent::MouseMove: return point(static_cast<QMouseEvent&>(*event));
        case QEvent::MouseButtonRelease:
            if (!m_drag) return false;
            if (!m_drag->isByPointer && static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) finish();
            return true;
        case QEvent::Wheel: return m_drag.has_value();  // the view stays where the drag began
        case QEvent::ShortcutOverride:
            if (m_drag) event->accept();
            return m_drag.has_value();
        case QEvent::KeyPress: return m_drag && takeKey(static_cast<QKeyEvent&>(*event));
        case QEvent::KeyRelease: return m_drag.has_value();
        default: return false;
    }
}

}  // namespace rubble
