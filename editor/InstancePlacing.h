#pragma once

#include "core/asset/ScenePlacing.h"
#include "editor/GizmoOverlay.h"
#include "editor/Workspace.h"

#include <QObject>

class QDropEvent;
class QKeyEvent;
class QMouseEvent;

namespace rubble {

class ViewportWidget;

/// Lets assets be placed in the 3D view: dragged from the project tree, or by clicks after begin(). One lands upright on the face
/// under the pointer, or on the ground; with Ctrl on a grid of 0.1 m. Where it will stand is drawn meanwhile.
class InstancePlacing : public QObject {
    Q_OBJECT
public:
    InstancePlacing(Workspace& workspace, ViewportWidget& viewport, GizmoOverlay& overlay);

    void setOn(bool isOn);
    /// From now on an instance of an asset follows the pointer; each click places one, R turns it by 15° about the vertical, with
    /// Shift the other way. Ended by Esc or the right button.
    void begin(Id asset);
    void end();
    bool isClicking() const { return m_isClicking; }

signals:
    /// An asset was placed, or why not.
    void said(const QString& sentence);
    /// What mouse and keys do now; empty: what they always do.
    void hintChanged(const QString& hint);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::optional<Pose> poseAt(QPointF point, Qt::KeyboardModifiers modifiers) const;
    void showAt(const std::optional<Pose>& pose);
    void place(const std::optional<Pose>& pose);
    bool takeDrag(QDropEvent& event);
    bool takeClicking(QEvent& event);
    bool takeMouse(const QMouseEvent& event);
    bool takeKey(QKeyEvent& event);
    void tellHint();
    void follow(Qt::KeyboardModifiers modifiers);

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    GizmoOverlay& m_overlay;
    bool m_isOn = true;
    bool m_isClicking = false;
    bool m_isMenuDue = false;  // of the right button that ended it
    Id m_asset = 0;            // that is being dragged or placed
    int m_turns = 0;           // by InstanceGizmo::kStepDegrees
    QPointF m_pointer;
    AssetHulls m_hulls;
};

}  // namespace rubble
