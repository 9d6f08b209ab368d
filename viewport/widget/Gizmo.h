#pragma once

#include "viewport/scene/Camera.h"

#include <optional>
#include <vector>

namespace rubble {

/// The handles of a transform gizmo: along an axis, in a plane, in the plane of the view, about an axis.
enum class GizmoHandle { MoveX, MoveY, MoveZ, MoveYz, MoveZx, MoveXy, MoveInView, RotateX, RotateY, RotateZ };
enum class GizmoMode { Move, Rotate };

/// The position of a gizmo and its camera. Its size on screen is constant.
struct GizmoView {
    Camera camera;
    ImageSize size;  // of the widget, in points
    Vec3 centre{0.0, 0.0, 0.0};
};

/// The handles of a mode in drawing order.
std::vector<GizmoHandle> handlesOf(GizmoMode mode);

/// The axis of a handle, 0 to 2 for x to z: its direction, its rotation axis, or its plane's normal; nothing for
/// MoveInView.
std::optional<int> axisOf(GizmoHandle handle);
bool isRotationHandle(GizmoHandle handle);
bool isPlaneHandle(GizmoHandle handle);

/// The polyline of a handle on screen: an arrow's shaft, a plane's square, or a ring. Empty if the handle is seen too
/// nearly end-on to be grabbed, or lies behind the eye.
std::vector<Vec2> handleLine(GizmoHandle handle, const GizmoView& view);

/// The handle at a point of the screen, if one is near enough.
std::optional<GizmoHandle> handleAt(Vec2 point, GizmoMode mode, const GizmoView& view);

/// The displacement of a handle dragged from one pointer ray to another, m; nothing if a ray is nearly parallel to its
/// axis or plane. `view`: when the drag started.
std::optional<Vec3> translation(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to);

/// The angle by which a ring was rotated about its axis, rad in (-pi, pi]; if it is seen edge-on, the angle of the
/// pointer around its centre on screen.
std::optional<double> rotationAngle(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to);

/// Rounds to a multiple of `step`.
double snapped(double value, double step);

}  // namespace rubble
