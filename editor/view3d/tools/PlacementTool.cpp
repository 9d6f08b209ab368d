#include "editor/view3d/tools/PlacementTool.h"

#include "core/base/math/Trigonometry.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/DraggedAsset.h"
#include "editor/view3d/tools/GizmoPainting.h"
#include "editor/view3d/tools/TransformTool.h"
#include "editor/widgets/numbers/LocalizedQuantity.h"
#include "viewport/widget/ViewportWidget.h"

#include <QCursor>
#include <QGuiApplication>
#include <QtMath>

#include <cmath>
#include <utility>

namespace rubble {

namespace {

/// A rotation about the vertical by steps.
Quat uprightRotation(int steps) {
    const double half = qDegreesToRadians(0.5 * TransformTool::kStepDegrees * steps);
    return {cosine(half), 0.0, sine(half), 0.0};
}

}  // namespace

PlacementTool::PlacementTool(Workspace& workspace, ViewportWidget& viewport)
    : ViewportTool(&viewport), m_workspace(workspace), m_viewport(viewport) {
    viewport.setAcceptDrops(true);
    connect(&viewport, &ViewportWidget::cameraChanged, this, [this] {
        if (m_isPlacing) followPointer(QGuiApplication::keyboardModifiers());
    });
    connect(&workspace.document(), &Document::changed, this, [this] {
        if (!m_isPlacing) return;
        m_hulls = assetHulls(m_workspace.project());
        if (findAsset(m_workspace.project(), m_asset) == nullptr) end();
    });
}

void PlacementTool::setOn(bool isOn) {
    m_isOn = isOn;
    if (!isOn) end();
}

void PlacementTool::begin(Id asset) {
    if (!m_isOn) {
        return emit statusMessage(tr("To place instances, stop the simulation and show the scene."));
    }
    m_asset = asset;
    m_rotationSteps = 0;
    m_isPlacing = true;
    m_hulls = assetHulls(m_workspace.project());
    m_pointer = m_viewport.mapFromGlobal(QCursor::pos());
    m_viewport.setFocus();
    followPointer({});
    emitHint();
}

void PlacementTool::emitHint() {
    emit hintChanged(tr("Click: place · Ctrl: snap to %1 · R: rotate by %2 · Esc or right click: end")
                         .arg(localizedQuantity(QuantityKind::Length, TransformTool::kStep, m_units),
                              roundedQuantity(TransformTool::kStepDegrees, Units::angles())));
}

void PlacementTool::end() {
    if (!std::exchange(m_isPlacing, false)) return;
    m_rotationSteps = 0;
    showPreview(std::nullopt);
    emit hintChanged({});
}

bool PlacementTool::cancel() {
    const bool wasPlacing = m_isPlacing;
    end();
    return wasPlacing;
}

std::optional<Pose> PlacementTool::poseAt(QPointF point, Qt::KeyboardModifiers modifiers) const {
    const auto hulls = m_hulls.find(m_asset);
    const auto hit = sceneHit(m_workspace.project(), m_hulls, m_viewport.rayAt(point));
    if (!hit || hulls == m_hulls.end() || !m_viewport.rect().contains(point.toPoint())) return std::nullopt;
    Pose pose;
    pose.orientation = uprightRotation(m_rotationSteps);
    pose.position = restingPosition(hulls->second, pose.orientation, *hit);
    if (!modifiers.testFlag(Qt::ControlModifier)) return pose;
    for (int axis = 0; axis < 3; ++axis) {
        // Snaps along the face only, so that the instance still rests on it.
        const bool isAlong = std::abs(hit->normal[axis]) < 0.5;
        if (isAlong) pose.position[axis] = snapped(pose.position[axis], TransformTool::kStep);
    }
    return pose;
}

void PlacementTool::showPreview(const std::optional<Pose>& pose) {
    m_preview.clear();
    const auto hulls = m_hulls.find(m_asset);
    if (pose && hulls != m_hulls.end()) {
        for (const Polytope& hull : hulls->second) {
            for (const auto& [from, to] : hull.edges) {
                m_preview.push_back({pose->position + pose->orientation * hull.vertices[from],
                                     pose->position + pose->orientation * hull.vertices[to]});
            }
        }
    }
    emit changed();
}

void PlacementTool::paint(QPainter& painter, QSize /*size*/) const { paintEdges(painter, m_preview, m_viewport); }

void PlacementTool::place(const std::optional<Pose>& pose) {
    showPreview(std::nullopt);
    if (!pose) {
        emit statusMessage(tr("There is no ground or instance under the pointer."));
        return;
    }
    Addition added = placeInstance(m_workspace.project(), m_asset, *pose);
    if (!m_workspace.document().push(std::move(added.edit))) return;
    m_workspace.selection().setSeeds({});
    m_workspace.selection().setInstances(m_workspace.project(), {added.id});
    m_viewport.setFocus();
    if (m_isPlacing) emitHint();  // the selection may have replaced it
}

void PlacementTool::followPointer(Qt::KeyboardModifiers modifiers) { showPreview(poseAt(m_pointer, modifiers)); }

bool PlacementTool::drag(QDropEvent& event) {
    if (!m_isOn) return false;
    end();
    m_asset = draggedAsset(event.mimeData());
    if (findAsset(m_workspace.project(), m_asset) == nullptr) return false;
    if (event.type() == QEvent::DragEnter) m_hulls = assetHulls(m_workspace.project());
    const std::optional<Pose> pose = poseAt(event.position(), event.modifiers());
    event.type() == QEvent::Drop ? place(pose) : showPreview(pose);
    event.setDropAction(Qt::CopyAction);
    event.accept();
    return true;
}

bool PlacementTool::isNavigating(const QMouseEvent& event) const {
    return event.modifiers().testFlag(Qt::AltModifier) ||
           event.buttons().testAnyFlags(Qt::MiddleButton | Qt::RightButton);
}

bool PlacementTool::press(const QMouseEvent& event) {
    if (!m_isPlacing) return false;
    if (event.button() == Qt::RightButton) {
        m_isMenuDue = true;
        end();
        return true;
    }
    if (isNavigating(event)) return false;
    m_pointer = event.position();
    if (event.button() != Qt::LeftButton) return false;
    place(poseAt(m_pointer, event.modifiers()));
    return true;
}

bool PlacementTool::move(const QMouseEvent& event) {
    if (!m_isPlacing || isNavigating(event)) return false;
    m_pointer = event.position();
    followPointer(event.modifiers());
    return true;
}

bool PlacementTool::release(const QMouseEvent& event) {
    if (!m_isPlacing || isNavigating(event)) return false;
    m_pointer = event.position();
    return event.button() == Qt::LeftButton;
}

void PlacementTool::leave() {
    if (m_isPlacing) showPreview(std::nullopt);
}

bool PlacementTool::suppressesContextMenu() { return std::exchange(m_isMenuDue, false); }

bool PlacementTool::overridesShortcut(const QKeyEvent& event) const {
    const bool isRotation =
        event.key() == Qt::Key_R && !event.modifiers().testAnyFlags(Qt::ControlModifier | Qt::AltModifier);
    return m_isPlacing && (isRotation || event.key() == Qt::Key_Escape);
}

bool PlacementTool::keyPress(const QKeyEvent& event) {
    if (m_isPlacing && event.key() == Qt::Key_Control) followPointer(Qt::ControlModifier);
    if (!overridesShortcut(event)) return false;
    if (event.key() == Qt::Key_Escape) return cancel();
    m_rotationSteps += event.modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1;
    followPointer(event.modifiers());
    return true;
}

bool PlacementTool::keyRelease(const QKeyEvent& event) {
    if (m_isPlacing && event.key() == Qt::Key_Control) followPointer(Qt::NoModifier);
    return overridesShortcut(event);
}

}  // namespace rubble

#include "moc_PlacementTool.cpp"
