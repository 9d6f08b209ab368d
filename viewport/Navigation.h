#pragma once

#include "viewport/scene/Camera.h"

#include <Qt>

#include <optional>

namespace rubble {

/// Whose habits moving the view follows.
enum class NavigationStyle {
    Blender,  // middle button orbits, with Shift pans, with Ctrl zooms; Alt and the left button do the same
    Maya      // Alt with left, middle, right: orbits, pans, zooms
};

enum class Drag { Orbit, Pan, Zoom };

/// What dragging with a button does; nothing where it is left to others.
std::optional<Drag> dragOf(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// The camera after the pointer was dragged by some pixels (y downwards).
Camera dragged(const Camera& camera, Drag drag, Vec2 pixels, PictureSize size);

/// The factor by which the wheel brings the eye nearer; `eighths` of a degree, as QWheelEvent tells them.
double wheelFactor(double eighths);

/// What a key does with the view.
enum class ViewAction { FrameAll, FrameSelected, ToggleProjection, ZoomIn, ZoomOut };
struct ViewKey {
    std::optional<ViewAction> action;
    std::optional<StandardView> view;
    Vec2 orbit{0.0, 0.0};      // rad of azimuth and elevation
    Vec2 panPoints{0.0, 0.0};  // points that the scene moves by, y downwards
};

/// Blender's keys, on the number pad and above the letters alike: 1, 3, 7 front, right and top, with Ctrl from the other side;
/// 9 the other side of 7's; 5 parallel or not; 4, 6, 8, 2 and the arrows orbit by 15 degrees, arrows with Shift pan; + and
/// - zoom; F and . frame what is selected, Home (in Maya's style A, too) all.
std::optional<ViewKey> viewKeyOf(NavigationStyle style, int key, Qt::KeyboardModifiers modifiers);

}  // namespace rubble
