#pragma once

#include "viewport/scene/Camera.h"

#include <Qt>

#include <optional>

namespace rubble {

/// The mouse navigation scheme.
enum class NavigationStyle {
    Blender,  // middle button orbits, with Shift pans, with Ctrl zooms; Alt and the left button do the same
    Maya      // Alt with left, middle, right: orbits, pans, zooms
};

enum class Drag { Orbit, Pan, Zoom };

/// The navigation of a mouse drag; nothing if the drag does not navigate.
std::optional<Drag> dragOf(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers);

/// The camera after a drag by `pixels` (y downwards).
Camera dragged(const Camera& camera, Drag drag, Vec2 pixels, ImageSize size);

/// The factor for the camera's distance after a wheel rotation in eighths of a degree, as in QWheelEvent.
double wheelFactor(double eighths);

/// The effect of a key on the view.
enum class ViewAction { FrameAll, FrameSelected, ToggleProjection, ZoomIn, ZoomOut };
struct ViewKey {
    std::optional<ViewAction> action;
    std::optional<StandardView> view;
    Vec2 orbit{0.0, 0.0};      // rad of azimuth and elevation
    Vec2 panPoints{0.0, 0.0};  // displacement of the scene in points, y downwards
};

/// Blender's keys, on the number pad and in the digit row: 1, 3, 7 front, right and top, with Ctrl the opposite sides;
/// 9 bottom; 5 toggles perspective; 4, 6, 8, 2 and the arrow keys orbit by 15 degrees, arrow keys with Shift pan; + and
/// - zoom; F and . frame the selection, Home (in Maya style also A) frames all.
std::optional<ViewKey> viewKeyOf(NavigationStyle style, int key, Qt::KeyboardModifiers modifiers);

}  // namespace rubble
