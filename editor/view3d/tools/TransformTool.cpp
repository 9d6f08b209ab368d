#include "editor/view3d/tools/TransformTool.h"

#include "core/base/math/Trigonometry.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/ShownText.h"
#include "editor/view3d/tools/GizmoPainting.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "editor/widgets/numbers/NumberText.h"
#include "viewport/widget/ViewportWidget.h"

#include <QLocale>
#include <QtMath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {

namespace {

constexpr int kDecimals = 3;  // of metres beside the pointer
constexpr int kDegreeDecimals = 1;

QString axisName(int axis) { return QString(QChar('x' + axis)); }

QString signedText(double value, int decimals, const NumberFormat& format) {
    return (value < 0.0 ? QStringLiteral("−") : QStringLiteral("+")) + fixedText(std::abs(value), decimals, format);
}

/// The displacement along the axes that the handle can change: "x +0.300  z −1.200 m".
QString lengthsText(GizmoHandle handle, Vec3 moved, const NumberFormat& format) {
    QStringList parts;
    for (int axis = 0; axis < 3; ++axis) {
        const bool isHeld = axisOf(handle) && isPlaneHandle(handle) == (axis == *axisOf(handle));
        if (!isHeld) parts.append(axisName(axis) + ' ' + signedText(moved[axis], kDecimals, format));
    }
    return withUnit(parts.join("  "), format);
}

Quat rotationAbout(int axis, double angle) {
    Quat rotation{cosine(angle / 2.0), 0.0, 0.0, 0.0};
    (axis == 0 ? rotation.x : axis == 1 ? rotation.y : rotation.z) = sine(angle / 2.0);
    return rotation;
}

/// The centre of an asset's box, in its prism's frame.
Vec3 centreOf(const Asset& asset) {
    if (const ClosedMesh* mesh = asset.mesh()) return mesh->bounds.centre();
    const Box2 bounds = boundsOf(asset.prism().outline.outer);
    return {0.5 * (bounds.min + bounds.max), 0.0};
}

/// True for a letter of a unit that may be typed after a number: 5' 3", 40 cm. None of them is an axis.
bool isOfUnit(QChar letter, bool isRotation) {
    return (isRotation ? QStringLiteral("°deg") : QStringLiteral("mcftin'\" ")).contains(letter);
}

/// The handle that X, Y or Z constrains a drag to; nothing for other keys.
std::optional<GizmoHandle> constrainedHandle(int key, bool isPlane, bool isRotation) {
    using enum GizmoHandle;
    switch (key) {
        case Qt::Key_X: return isRotation ? RotateX : isPlane ? MoveYz : MoveX;
        case Qt::Key_Y: return isRotation ? RotateY : isPlane ? MoveZx : MoveY;
        case Qt::Key_Z: return isRotation ? RotateZ : isPlane ? MoveXy : MoveZ;
        default: return std::nullopt;
    }
}

}  // namespace

TransformTool::TransformTool(Workspace& workspace, ViewportWidget& viewport)
    : ViewportTool(&viewport), m_workspace(workspace), m_viewport(viewport) {
    connect(&workspace.document(), &Document::changed, this, [this](const Changes& changes) {
        if (m_drag && (changes.isUndoOrRedo || changes.isEverything)) finish();  // its starting state is gone
        endIfOthersAreSelected();
    });
    // At once: a drag must not find out by its own next change, in the middle of it.
    connect(&workspace.selection(), &Selection::instancesChanged, this, &TransformTool::endIfOthersAreSelected);
    connect(&workspace.selection(), &Selection::subjectChanged, this, &TransformTool::endIfOthersAreSelected);
}

void TransformTool::endIfOthersAreSelected() {
    if (m_drag && movable() != m_drag->instances) return finish();
    emit changed();
}

void TransformTool::setOn(bool isOn) {
    if (!isOn) cancel();
    m_isOn = isOn;
    emit changed();
}

void TransformTool::setMode(GizmoMode mode) {
    if (mode == m_mode || m_drag) return;
    m_mode = mode;
    m_hovered.reset();
    emit changed();
    emit modeChanged(mode);
}

std::vector<Id> TransformTool::movable() const {
    std::vector<Id> ids;
    if (!m_isOn || m_workspace.selection().subject() != Part::Instance) return ids;
    for (const Instance& instance : m_workspace.project().instances) {
        const bool isFree = !instance.isLocked && !instance.isHidden;
        if (isFree && m_workspace.selection().instances().contains(instance.id)) ids.push_back(instance.id);
    }
    return ids;
}

/// The mean centre of the movable instances.
std::optional<Vec3> TransformTool::centre() const {
    const std::vector<Id> ids = movable();
    if (ids.empty()) return std::nullopt;
    Vec3 sum(0.0);
    for (const Id id : ids) {
        const Instance& instance = *findInstance(m_workspace.project(), id);
        sum += instance.pose.position +
               instance.pose.orientation * centreOf(*findAsset(m_workspace.project(), instance.asset));
    }
    return sum / static_cast<double>(ids.size());
}

std::optional<GizmoView> TransformTool::gizmoView() const {
    const std::optional<Vec3> at = centre();
    if (!at) return std::nullopt;
    const ImageSize size{std::max(1, m_viewport.width()), std::max(1, m_viewport.height())};
    return GizmoView{m_viewport.shownCamera(), size, *at};
}

void TransformTool::paint(QPainter& painter, QSize size) const {
    if (const std::optional<GizmoView> view = gizmoView()) {
        const GizmoMode mode = !m_drag                            ? m_mode
                               : isRotationHandle(m_drag->handle) ? GizmoMode::Rotate
                                                                  : GizmoMode::Move;
        const std::optional<GizmoHandle> highlighted = m_drag ? m_drag->handle : m_hovered;
        for (const GizmoHandle handle : handlesOf(mode)) {
            if (!m_drag || handle == highlighted) paintHandle(painter, handle, *view, handle == highlighted);
        }
    }
    if (m_drag) paintPointerLabel(painter, m_pointer, m_label, size);
}

void TransformTool::start(GizmoHandle handle, QPointF pointer) {
    const std::optional<GizmoView> view = gizmoView();
    if (!view) return;
    m_pointer = pointer;
    m_drag = {.handle = handle,
              .view = *view,
              .from = m_viewport.rayAt(pointer),
              .instances = movable(),
              .mergeKey = m_workspace.document().newMergeKey(),
              .hulls = assetHulls(m_workspace.project())};
    for (const Id id : m_drag->instances) m_drag->poses.push_back(findInstance(m_workspace.project(), id)->pose);
    m_label.clear();
    emit hintChanged(isRotationHandle(handle)
                         ? tr("X, Y, Z: rotate about this axis · Ctrl: snap to 15° · Type an angle, then Enter · "
                              "Esc: cancel")
                         : tr("X, Y, Z: move along this axis, with Shift in the plane perpendicular to it · "
                              "Ctrl: snap to %1 · Shift: place on the face under the pointer · "
                              "Type a distance, then Enter · Esc: cancel")
                               .arg(localizedQuantity(QuantityKind::Length, kStep, m_units)));
    emit changed();
}

void TransformTool::startWithPointer(GizmoHandle handle) {
    if (m_drag) return;
    start(handle, m_pointer);
    if (m_drag) m_drag->isByPointer = true;
}

void TransformTool::push(const QString& text, const std::vector<Pose>& poses) {
    const Project& project = m_workspace.project();
    m_workspace.document().push(rubble::moveInstances(text, project, m_drag->instances, poses, m_drag->mergeKey));
}

/// An entered number holds against the pointer.
void TransformTool::followPointer(QPointF pointer, Qt::KeyboardModifiers modifiers) {
    m_pointer = pointer;
    if (!m_drag->typed.isEmpty()) return applyTyped();
    isRotationHandle(m_drag->handle) ? rotateInstances(modifiers) : moveInstances(modifiers);
    emit changed();
}

void TransformTool::moveInstances(Qt::KeyboardModifiers modifiers) {
    const bool isFree = m_drag->handle == GizmoHandle::MoveInView;
    if (isFree && modifiers.testFlag(Qt::ShiftModifier) && placeOnFace()) return;
    std::optional<Vec3> moved = translation(m_drag->handle, m_drag->view, m_drag->from, m_viewport.rayAt(m_pointer));
    if (!moved) return;
    for (int axis = 0; axis < 3 && modifiers.testFlag(Qt::ControlModifier); ++axis) {
        (*moved)[axis] = snapped((*moved)[axis], kStep);
    }
    showMoved(*moved);
}

void TransformTool::showMoved(Vec3 moved) {
    std::vector<Pose> poses = m_drag->poses;
    for (Pose& pose : poses) pose.position += moved;
    m_label = lengthsText(m_drag->handle, moved, m_units.lengths());
    push(tr("Move"), poses);
}

/// False unless a single instance is moved and there is a face.
bool TransformTool::placeOnFace() {
    const Project& project = m_workspace.project();
    if (m_drag->instances.size() != 1) return false;
    const Instance& instance = *findInstance(project, m_drag->instances.front());
    const auto hit = sceneHit(project, m_drag->hulls, m_viewport.rayAt(m_pointer), m_drag->instances);
    if (!hit || !m_drag->hulls.contains(instance.asset)) return false;
    Pose pose = m_drag->poses.front();
    pose.position = restingPosition(m_drag->hulls.at(instance.asset), pose.orientation, *hit);
    const Instance* on = findInstance(project, hit->instance);
    m_label = on ? tr("on %1").arg(nameText(on->name)) : tr("on the ground");
    push(tr("Move"), {pose});
    return true;
}

void TransformTool::rotateInstances(Qt::KeyboardModifiers modifiers) {
    const auto angle = rotationAngle(m_drag->handle, m_drag->view, m_drag->from, m_viewport.rayAt(m_pointer));
    if (!angle) return;
    // Accumulated, so that more than half a turn is possible.
    m_drag->angle += std::remainder(*angle - m_drag->lastAngle, 2.0 * std::numbers::pi);
    m_drag->lastAngle = *angle;
    double degrees = qRadiansToDegrees(m_drag->angle);
    if (modifiers.testFlag(Qt::ControlModifier)) degrees = snapped(degrees, kStepDegrees);
    showRotated(degrees);
}

void TransformTool::showRotated(double degrees) {
    const int axis = *axisOf(m_drag->handle);
    const Quat rotation = rotationAbout(axis, qDegreesToRadians(degrees));
    std::vector<Pose> poses = m_drag->poses;
    for (Pose& pose : poses) {
        pose.position = m_drag->view.centre + rotation * (pose.position - m_drag->view.centre);
        pose.orientation = glm::normalize(rotation * pose.orientation);
    }
    m_label = axisName(axis) + ' ' + withUnit(signedText(degrees, kDegreeDecimals, Units::angles()), Units::angles());
    push(tr("Rotate"), poses);
}

/// Continues the drag with another handle, from its start; the same handle again removes the constraint.
void TransformTool::constrain(GizmoHandle handle, Qt::KeyboardModifiers modifiers) {
    m_drag->handle = m_drag->handle == handle && !isRotationHandle(handle) ? GizmoHandle::MoveInView : handle;
    m_drag->angle = m_drag->lastAngle = 0.0;
    modifiers.setFlag(Qt::ShiftModifier, false);
    followPointer(m_pointer, modifiers);
}

bool TransformTool::cancel() {
    if (!m_drag) return false;
    push(isRotationHandle(m_drag->handle) ? tr("Rotate") : tr("Move"), m_drag->poses);
    finish();
    return true;
}

void TransformTool::finish() {
    m_drag.reset();
    m_hovered.reset();
    emit hintChanged({});
    emit changed();
}

/// Handles that are not seen cannot be dragged.
std::optional<GizmoView> TransformTool::seenHandles() const {
    return m_viewport.hasOverlays() ? gizmoView() : std::nullopt;
}

bool TransformTool::press(const QMouseEvent& event) {
    if (!m_isOn) return false;
    if (m_drag) {
        if (event.button() == Qt::RightButton) return cancel();
        if (m_drag->isByPointer && event.button() == Qt::LeftButton) finish();
        return true;
    }
    const bool isPlain = event.button() == Qt::LeftButton && !event.modifiers().testFlag(Qt::AltModifier);
    const std::optional<GizmoView> view = seenHandles();
    if (!isPlain || !view) return false;
    const auto handle = handleAt({event.position().x(), event.position().y()}, m_mode, *view);
    if (handle) start(*handle, event.position());
    return handle.has_value();
}

bool TransformTool::move(const QMouseEvent& event) {
    if (!m_isOn) return false;
    if (m_drag) return followPointer(event.position(), event.modifiers()), true;
    m_pointer = event.position();
    const std::optional<GizmoView> view = seenHandles();
    std::optional<GizmoHandle> hovered;
    if (view && event.buttons() == Qt::NoButton) hovered = handleAt({m_pointer.x(), m_pointer.y()}, m_mode, *view);
    if (hovered != m_hovered) {
        m_hovered = hovered;
        emit changed();
    }
    return hovered.has_value();
}

bool TransformTool::release(const QMouseEvent& event) {
    if (!m_drag) return false;
    if (!m_drag->isByPointer && event.button() == Qt::LeftButton) finish();
    return true;
}

/// Adds a key to the entered number, or removes its last character. False for other keys.
bool TransformTool::typeNumber(const QKeyEvent& event) {
    QString& typed = m_drag->typed;
    const QChar letter = event.text().isEmpty() ? QChar() : event.text().front();
    const bool isSign = letter == '-' && typed.isEmpty();
    const bool isUnit = !typed.isEmpty() && typed != "-" && isOfUnit(letter, isRotationHandle(m_drag->handle));
    if (event.key() == Qt::Key_Backspace) {
        typed.chop(1);
    } else if (letter.isDigit() || letter == '.' || QString(letter) == QLocale().decimalPoint() || isSign || isUnit) {
        typed += letter == '.' ? QLocale().decimalPoint() : QString(letter);
    } else {
        return false;
    }
    typed.isEmpty() ? followPointer(m_pointer, {}) : applyTyped();
    emit changed();
    return true;
}

/// Moves along the constrained axis, or else along x, or rotates by the entered number; what is no number yet is 0.
void TransformTool::applyTyped() {
    const bool isRotation = isRotationHandle(m_drag->handle);
    const NumberFormat format = isRotation ? Units::angles() : m_units.lengths();
    const std::optional<double> typed = parseNumber(m_drag->typed, format, QLocale());
    const double value = typed.value_or(0.0);
    if (isRotation) {
        showRotated(value);
    } else {
        const bool isAlongAxis = axisOf(m_drag->handle) && !isPlaneHandle(m_drag->handle);
        if (!isAlongAxis) m_drag->handle = GizmoHandle::MoveX;
        Vec3 moved(0.0);
        moved[*axisOf(m_drag->handle)] = value;
        showMoved(moved);
    }
    const QString name = axisName(*axisOf(m_drag->handle));
    const bool hasUnit = std::ranges::any_of(m_drag->typed, [&](QChar c) { return isOfUnit(c, isRotation); });
    m_label = name + ' ' + (hasUnit ? m_drag->typed : withUnit(m_drag->typed, format));
    if (!typed && hasUnit) m_label += tr(": not a known unit");
}

/// During a drag all keys are consumed.
bool TransformTool::keyPress(const QKeyEvent& event) {
    if (!m_drag) return false;
    if (typeNumber(event)) return true;
    const bool isPlane = event.modifiers().testFlag(Qt::ShiftModifier);
    const auto handle = constrainedHandle(event.key(), isPlane, isRotationHandle(m_drag->handle));
    if (handle) constrain(*handle, event.modifiers());
    if (event.key() == Qt::Key_Escape) cancel();
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) finish();
    return true;
}

}  // namespace rubble

#include "moc_TransformTool.cpp"
