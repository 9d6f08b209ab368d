#pragma once

#include "core/asset/placement/InstancePlacement.h"
#include "editor/widgets/numbers/Units.h"
#include "editor/workspace/Workspace.h"
#include "viewport/widget/Gizmo.h"
#include "viewport/widget/ViewportTool.h"

#include <optional>
#include <vector>

namespace rubble {

class ViewportWidget;

/// Moves and rotates the selected instances in the 3D view: by the handles of a gizmo, or after startMove() and
/// startRotation() by the pointer alone until a click. X, Y and Z constrain to an axis, with Shift to the plane
/// perpendicular to it; Ctrl snaps to steps; Shift, while one instance is moved freely, places it on the face under the
/// pointer; numbers typed are the distance along the axis, or the angle; Escape and the right button cancel. A drag is
/// one undo step. Locked and hidden instances stay.
class TransformTool : public ViewportTool {
    Q_OBJECT
public:
    static constexpr double kStep = 0.1;  // m
    static constexpr double kStepDegrees = 15.0;

    TransformTool(Workspace& workspace, ViewportWidget& viewport);

    /// While it is off, it is not shown and ignores input.
    void setOn(bool isOn);
    /// The units of distances, shown and typed.
    void setUnits(const Units& units) { m_units = units; }
    GizmoMode mode() const { return m_mode; }
    void setMode(GizmoMode mode);
    /// Starts moving or rotating the selected instances with the pointer.
    void startMove() { startWithPointer(GizmoHandle::MoveInView); }
    void startRotation() { startWithPointer(GizmoHandle::RotateY); }
    bool isDragging() const { return m_drag.has_value(); }

    /// The selected instances that can be transformed.
    std::vector<Id> movable() const;
    /// The gizmo on screen; nothing if there is none.
    std::optional<GizmoView> gizmoView() const;

    bool press(const QMouseEvent& event) override;
    bool move(const QMouseEvent& event) override;
    bool release(const QMouseEvent& event) override;
    bool wheel(const QWheelEvent& /*event*/) override { return isDragging(); }  // the view stays where the drag started
    bool keyPress(const QKeyEvent& event) override;
    bool keyRelease(const QKeyEvent& /*event*/) override { return isDragging(); }
    bool overridesShortcut(const QKeyEvent& /*event*/) const override { return isDragging(); }
    bool cancel() override;
    void paint(QPainter& painter, QSize size) const override;

signals:
    void modeChanged(rubble::GizmoMode mode);

private:
    std::optional<GizmoView> seenHandles() const;
    /// The current drag.
    struct Drag {
        GizmoHandle handle;
        bool isByPointer = false;  // without a button
        GizmoView view;            // at its start
        Ray from;
        double angle = 0.0, lastAngle = 0.0;  // rad
        std::vector<Id> instances;
        std::vector<Pose> poses;  // at its start
        quint64 mergeKey = 0;
        AssetHulls hulls;
        QString typed;  // a number, as typed so far; empty: the pointer counts
    };

    std::optional<Vec3> centre() const;
    void start(GizmoHandle handle, QPointF pointer);
    void startWithPointer(GizmoHandle handle);
    void followPointer(QPointF pointer, Qt::KeyboardModifiers modifiers);
    void moveInstances(Qt::KeyboardModifiers modifiers);
    void rotateInstances(Qt::KeyboardModifiers modifiers);
    bool placeOnFace();
    void push(const QString& text, const std::vector<Pose>& poses);
    void showMoved(Vec3 moved);
    void showRotated(double degrees);
    bool typeNumber(const QKeyEvent& event);
    void applyTyped();
    void constrain(GizmoHandle handle, Qt::KeyboardModifiers modifiers);
    void finish();
    void endIfOthersAreSelected();

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    GizmoMode m_mode = GizmoMode::Move;
    bool m_isOn = true;
    QPointF m_pointer;
    std::optional<GizmoHandle> m_hovered;
    QString m_label;
    Units m_units;
    std::optional<Drag> m_drag;
};

}  // namespace rubble
