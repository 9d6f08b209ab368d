#pragma once

#include "viewport/scene/Camera.h"

#include <optional>
#include <vector>

namespace rubble {

/// What can be taken hold of to move or turn what is chosen.
enum class GizmoHandle { MoveX, MoveY, MoveZ, MoveYz, MoveZx, MoveXy, MoveFreely, TurnX, TurnY, TurnZ };
enum class GizmoMode { Move, Turn };

/// Where a gizmo stands and from where it is seen. It is as large in the picture from near as from afar.
struct GizmoView {
    Camera camera;
    PictureSize size;  // of the widget, in points
    Vec3 middle{0.0, 0.0, 0.0};
};

/// The handles of a mode, those drawn on top last.
std::vector<GizmoHandle> handlesOf(GizmoMode mode);

/// 0, 1 or 2 for x, y or z: along or about which a handle goes, of a plane the axis it is square to; nothing for MoveFreely.
std::optional<int> axisOf(GizmoHandle handle);
bool isTurn(GizmoHandle handle);
bool isPlane(GizmoHandle handle);

/// The line of a handle in the picture: from the middle to an arrow's tip, around a plane's square, a ring. Empty where it is
/// seen so end-on that nobody could take hold of it, or lies behind the eye.
std::vector<Vec2> lineOf(GizmoHandle handle, const GizmoView& view);

/// The handle at a point of the picture, if it is near enough.
std::optional<GizmoHandle> handleAt(Vec2 point, GizmoMode mode, const GizmoView& view);

/// How far a handle was moved, from one ray through the pointer to another, m; nothing where a ray tells nothing about it.
/// `view`: as it was when the handle was taken.
std::optional<Vec3> movedBy(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to);

/// How far a ring was turned about its axis, rad in (-pi, pi]; one that is seen edge-on turns as the pointer does around it in the
/// picture.
std::optional<double> turnedBy(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to);

/// Rounded to whole steps.
double snapped(double value, double step);

}  // namespace rubble
