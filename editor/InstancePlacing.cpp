#include "editor/InstancePlacing.h"

#include "core/base/Trigonometry.h"
#include "editor/InstanceGizmo.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/DraggedAsset.h"
#include "viewport/ViewportWidget.h"

#include <QDropEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QtMath>

namespace rubble {

namespace {

/// Upright, turned by whole steps.
Quat uprightTurn(int steps) {
    const double half = qDegreesToRadians(0.5 * InstanceGizmo::kStepDegrees * steps);
    return {cosine(half), 0.0, sine(half), 0.0};
}

}  // namespace

InstancePlacing::InstancePlacing(Workspace& workspace, ViewportWidget& viewport, GizmoOverlay& overlay)
    : QObject(&viewport), m_workspace(workspace), m_viewport(viewport), m_overlay(overlay) {
    viewport.setAcceptDrops(true);
    viewport.installEventFilter(this);
    connect(&viewport, &ViewportWidget::cameraChanged, this, [this] {
        if (m_isClicking) follow(QGuiApplication::keyboardModifiers());
    });
    connect(&workspace.document(), &Document::changed, this, [this] {
        if (!m_isClicking) return;
        m_hulls = assetHulls(m_workspace.project());
        if (findAsset(m_workspace.project(), m_asset) == nullptr) end();
    });
}

void InstancePlacing::setOn(bool isOn) {
    m_isOn = isOn;
    if (!isOn) end();
}

void InstancePlacing::begin(Id asset) {
    if (!m_isOn) return emit said(tr("Instances are placed where the whole scene is shown and nothing is played."));
    m_asset = asset;
    m_turns = 0;
    m_isClicking = true;
    m_hulls = assetHulls(m_workspace.project());
    m_pointer = m_viewport.mapFromGlobal(QCursor::pos());
    m_viewport.setFocus();
    follow({});
    tellHint();
}

void InstancePlacing::tellHint() {
    emit hintChanged(tr("A click places it · Ctrl on a grid of 0.1 m · R turns it · Esc or right button ends"));
}

void InstancePlacing::end() {
    if (!std::exchange(m_isClicking, false)) return;
    m_turns = 0;
    showAt(std::nullopt);
    emit hintChanged({});
}

std::optional<Pose> InstancePlacing::poseAt(QPointF point, Qt::KeyboardModifiers modifiers) const {
    const auto hulls = m_hulls.find(m_asset);
    const auto hit = sceneHit(m_workspace.project(), m_hulls, m_viewport.rayAt(point));
    if (!hit || hulls == m_hulls.end() || !m_viewport.rect().contains(point.toPoint())) return std::nullopt;
    Pose pose;
    pose.orientation = uprightTurn(m_turns);
    pose.position = restingPosition(hulls->second, pose.orientation, *hit);
    if (!modifiers.testFlag(Qt::ControlModifier)) return pose;
    for (int axis = 0; axis < 3; ++axis) {
        // Along the face: square to it, it rests where it rests.
        const bool isAlong = std::abs(hit->normal[axis]) < 0.5;
        if (isAlong) pose.position[axis] = snapped(pose.position[axis], InstanceGizmo::kStep);
    }
    return pose;
}

void InstancePlacing::showAt(const std::optional<Pose>& pose) {
    GizmoOverlay::Content content = m_overlay.content();
    content.edges.clear();
    const auto hulls = m_hulls.find(m_asset);
    if (pose && hulls != m_hulls.end()) {
        for (const Polytope& hull : hulls->second) {
            for (const auto& [from, to] : hull.edges) {
                content.edges.push_back({pose->position + pose->orientation * hull.vertices[from],
                                         pose->position + pose->orientation * hull.vertices[to]});
            }
        }
    }
    m_overlay.setContent(content);
}

void InstancePlacing::place(const std::optional<Pose>& pose) {
    showAt(std::nullopt);
    if (!pose) {
        emit said(tr("There is neither ground nor an instance there to stand on."));
        return;
    }
    Addition added = placeInstance(m_workspace.project(), m_asset, *pose);
    m_workspace.document().push(std::move(added.edit));
    m_workspace.selection().setSeeds({});
    m_workspace.selection().setInstances(m_workspace.project(), {added.id});
    m_viewport.setFocus();
    if (m_isClicking) tellHint();  // others have told theirs
}

void InstancePlacing::follow(Qt::KeyboardModifiers modifiers) { showAt(poseAt(m_pointer, modifiers)); }

bool InstancePlacing::takeDrag(QDropEvent& event) {
    end();
    m_asset = draggedAsset(event.mimeData());
    if (findAsset(m_workspace.project(), m_asset) == nullptr) return false;
    if (event.type() == QEvent::DragEnter) m_hulls = assetHulls(m_workspace.project());
    const std::optional<Pose> pose = poseAt(event.position(), event.modifiers());
    event.type() == QEvent::Drop ? place(pose) : showAt(pose);
    event.setDropAction(Qt::CopyAction);
    event.accept();
    return true;
}

/// With another button than the left the view is moved about as always.
bool InstancePlacing::takeMouse(const QMouseEvent& event) {
    const bool isPress = event.type() == QEvent::MouseButtonPress;
    if (isPress && event.button() == Qt::RightButton) {
        m_isMenuDue = true;
        end();
        return true;
    }
    const bool isNavigating =
        event.modifiers().testFlag(Qt::AltModifier) || event.buttons().testAnyFlags(Qt::MiddleButton | Qt::RightButton);
    if (isNavigating) return false;
    m_pointer = event.position();
    if (isPress && event.button() == Qt::LeftButton) place(poseAt(m_pointer, event.modifiers()));
    if (event.type() == QEvent::MouseMove) follow(event.modifiers());
    return event.type() == QEvent::MouseMove || event.button() == Qt::LeftButton;
}

/// Keys are taken before shortcuts can be.
bool InstancePlacing::takeKey(QKeyEvent& event) {
    const bool isPress = event.type() == QEvent::KeyPress;
    if (event.key() == Qt::Key_Control) {
        follow(isPress ? Qt::ControlModifier : Qt::NoModifier);
        return false;
    }
    const bool isTurn =
        event.key() == Qt::Key_R && !event.modifiers().testAnyFlags(Qt::ControlModifier | Qt::AltModifier);
    if (!isTurn && event.key() != Qt::Key_Escape) return false;
    event.accept();
    if (!isPress) return true;
    if (isTurn) {
        m_turns += event.modifiers().testFlag(Qt::ShiftModifier) ? -1 : 1;
        follow(event.modifiers());
    } else {
        end();
    }
    return true;
}

bool InstancePlacing::takeClicking(QEvent& event) {
    switch (event.type()) {
        case QEvent::MouseButtonPress:
        case QEvent::MouseButtonDblClick:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseMove: return takeMouse(static_cast<QMouseEvent&>(event));
        case QEvent::ShortcutOverride:
        case QEvent::KeyPress:
        case QEvent::KeyRelease: return takeKey(static_cast<QKeyEvent&>(event));
        case QEvent::Leave: showAt(std::nullopt); return false;
        default: return false;
    }
}

bool InstancePlacing::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ContextMenu && std::exchange(m_isMenuDue, false)) return true;
    if (m_isClicking && takeClicking(*event)) return true;
    const bool isDrag =
        event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove || event->type() == QEvent::Drop;
    if (event->type() == QEvent::DragLeave) showAt(std::nullopt);
    if (!isDrag || !m_isOn) return QObject::eventFilter(watched, event);
    return takeDrag(static_cast<QDropEvent&>(*event));
}

}  // namespace rubble
