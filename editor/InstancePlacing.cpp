#include "editor/InstancePlacing.h"

#include "editor/InstanceGizmo.h"
#include "editor/commands/InstanceEdits.h"
#include "editor/document/DraggedAsset.h"
#include "viewport/ViewportWidget.h"

#include <QDropEvent>

namespace rubble {

InstancePlacing::InstancePlacing(Workspace& workspace, ViewportWidget& viewport, GizmoOverlay& overlay)
    : QObject(&viewport), m_workspace(workspace), m_viewport(viewport), m_overlay(overlay) {
    viewport.setAcceptDrops(true);
    viewport.installEventFilter(this);
}

std::optional<Pose> InstancePlacing::poseAt(const QDropEvent& event) const {
    const auto hulls = m_hulls.find(m_asset);
    const auto hit = sceneHit(m_workspace.project(), m_hulls, m_viewport.rayAt(event.position()));
    if (!hit || hulls == m_hulls.end()) return std::nullopt;
    Pose pose;
    pose.position = restingPosition(hulls->second, pose.orientation, *hit);
    if (!event.modifiers().testFlag(Qt::ControlModifier)) return pose;
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

void InstancePlacing::place(const QDropEvent& event) {
    const std::optional<Pose> pose = poseAt(event);
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
}

bool InstancePlacing::eventFilter(QObject* watched, QEvent* event) {
    const bool isDrag =
        event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove || event->type() == QEvent::Drop;
    if (event->type() == QEvent::DragLeave) showAt(std::nullopt);
    if (!isDrag || !m_isOn) return QObject::eventFilter(watched, event);
    auto& drag = static_cast<QDropEvent&>(*event);
    m_asset = draggedAsset(drag.mimeData());
    if (findAsset(m_workspace.project(), m_asset) == nullptr) return false;
    if (event->type() == QEvent::DragEnter) m_hulls = assetHulls(m_workspace.project());
    if (event->type() == QEvent::Drop) {
        place(drag);
    } else {
        showAt(poseAt(drag));
    }
    drag.setDropAction(Qt::CopyAction);
    drag.accept();
    return true;
}

}  // namespace rubble
