#pragma once

#include "core/asset/ScenePlacing.h"
#include "editor/GizmoOverlay.h"
#include "editor/Workspace.h"

#include <QObject>

class QDropEvent;

namespace rubble {

class ViewportWidget;

/// Lets assets be dragged from the project tree into the 3D view: one lands upright on the face under the pointer, or on the
/// ground; with Ctrl on a grid of 0.1 m. Where it will stand is drawn meanwhile.
class InstancePlacing : public QObject {
    Q_OBJECT
public:
    InstancePlacing(Workspace& workspace, ViewportWidget& viewport, GizmoOverlay& overlay);

    void setOn(bool isOn) { m_isOn = isOn; }

signals:
    /// An asset was placed, or why not.
    void said(const QString& sentence);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    std::optional<Pose> poseAt(const QDropEvent& event) const;
    void showAt(const std::optional<Pose>& pose);
    void place(const QDropEvent& event);

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    GizmoOverlay& m_overlay;
    bool m_isOn = true;
    Id m_asset = 0;  // that is being dragged
    AssetHulls m_hulls;
};

}  // namespace rubble
