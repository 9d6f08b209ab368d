#pragma once

#include "core/asset/ScenePlacing.h"
#include "editor/GizmoOverlay.h"
#include "editor/Workspace.h"

#include <QObject>

class QKeyEvent;
class QMouseEvent;

namespace rubble {

class ViewportWidget;

/// Moves and turns the chosen instances in the 3D view: by handles that are dragged, or after beginMoving() and beginTurning() by
/// the pointer alone, until a click. X, Y and Z hold it to an axis, with Shift to the plane square to it; Ctrl goes by steps;
/// Shift, while one instance is moved freely, lays it on the face under the pointer; Escape and the right button put all back.
/// A drag is one step that can be undone. Locked and hidden instances stay where they are.
class InstanceGizmo : public QObject {
    Q_OBJECT
public:
    static constexpr double kStep = 0.1;  // m
    static constexpr double kStepDegrees = 15.0;

    InstanceGizmo(Workspace& workspace, ViewportWidget& viewport);

    /// Where it is off, it is not shown and takes no events.
    void setOn(bool isOn);
    GizmoMode mode() const { return m_mode; }
    void setMode(GizmoMode mode);
    /// The pointer moves or turns what is chosen from now on.
    void beginMoving() { beginWithPointer(GizmoHandle::MoveFreely); }
    void beginTurning() { beginWithPointer(GizmoHandle::TurnY); }
    bool isDragging() const { return m_drag.has_value(); }
    void cancel();

    /// The chosen instances that may be moved.
    std::vector<Id> movable() const;
    GizmoOverlay& overlay() { return *m_overlay; }

signals:
    void modeChanged(rubble::GizmoMode mode);
    /// What the keys do just now; empty where nothing is dragged.
    void hintChanged(const QString& hint);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    /// A drag that is going on.
    struct Drag {
        GizmoHandle handle;
        bool isByPointer = false;  // no button is held
        GizmoView view;            // as it was at its begin
        Ray from;
        double turned = 0.0, lastAngle = 0.0;  // rad
        std::vector<Id> instances;
        std::vector<Pose> poses;  // as they were
        quint64 stroke = 0;
        AssetHulls hulls;
    };

    void show();
    std::optional<Vec3> middle() const;
    void begin(GizmoHandle handle, QPointF pointer);
    void beginWithPointer(GizmoHandle handle);
    void follow(QPointF pointer, Qt::KeyboardModifiers modifiers);
    void move(Qt::KeyboardModifiers modifiers);
    void turn(Qt::KeyboardModifiers modifiers);
    bool layOnFace();
    void push(const QString& text, const std::vector<Pose>& poses);
    void hold(GizmoHandle handle, Qt::KeyboardModifiers modifiers);
    void finish();
    bool press(const QMouseEvent& event);
    bool point(const QMouseEvent& event);
    bool takeKey(const QKeyEvent& event);

    Workspace& m_workspace;
    ViewportWidget& m_viewport;
    GizmoOverlay* m_overlay;
    GizmoMode m_mode = GizmoMode::Move;
    bool m_isOn = true;
    QPointF m_pointer;
    std::optional<GizmoHandle> m_hot;
    QString m_label;
    std::optional<Drag> m_drag;
};

}  // namespace rubble
