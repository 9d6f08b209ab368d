#include "viewport/widget/Navigation.h"

#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr double kOrbitPerHeight = std::numbers::pi;  // rad over the image height
constexpr double kZoomPerHeight = 6.0;                // e-folds over the image height
constexpr double kWheelStep = 1.2;                    // a notch
constexpr double kEighthsOfNotch = 120.0;
constexpr double kKeyOrbit = std::numbers::pi / 12.0;  // 15 degrees
constexpr double kKeyPan = 40.0;                       // points

ViewKey orbit(double azimuth, double elevation) { return {.orbit = {azimuth * kKeyOrbit, elevation * kKeyOrbit}}; }
ViewKey pan(double right, double down) { return {.panPoints = {right * kKeyPan, down * kKeyPan}}; }

ViewKey viewOrOpposite(StandardView view, StandardView opposite, Qt::KeyboardModifiers modifiers) {
    return {.view = modifiers.testFlag(Qt::ControlModifier) ? opposite : view};
}

std::optional<ViewKey> numberKey(int key, Qt::KeyboardModifiers modifiers) {
    if (modifiers.testAnyFlags(Qt::AltModifier | Qt::ShiftModifier | Qt::MetaModifier)) return std::nullopt;
    switch (key) {
        case Qt::Key_1: return viewOrOpposite(StandardView::Front, StandardView::Back, modifiers);
        case Qt::Key_3: return viewOrOpposite(StandardView::Right, StandardView::Left, modifiers);
        case Qt::Key_7: return viewOrOpposite(StandardView::Top, StandardView::Bottom, modifiers);
        case Qt::Key_9: return ViewKey{.view = StandardView::Bottom};
        case Qt::Key_5: return ViewKey{.action = ViewAction::ToggleProjection};
        case Qt::Key_4: return orbit(-1.0, 0.0);
        case Qt::Key_6: return orbit(1.0, 0.0);
        case Qt::Key_8: return orbit(0.0, 1.0);
        case Qt::Key_2: return orbit(0.0, -1.0);
        default: return std::nullopt;
    }
}

std::optional<ViewKey> arrowKey(int key, bool isPan) {
    switch (key) {
        case Qt::Key_Left: return isPan ? pan(-1.0, 0.0) : orbit(-1.0, 0.0);
        case Qt::Key_Right: return isPan ? pan(1.0, 0.0) : orbit(1.0, 0.0);
        case Qt::Key_Up: return isPan ? pan(0.0, -1.0) : orbit(0.0, 1.0);
        case Qt::Key_Down: return isPan ? pan(0.0, 1.0) : orbit(0.0, -1.0);
        default: return std::nullopt;
    }
}

}  // namespace

std::optional<Drag> dragOf(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
    const bool hasAlt = modifiers.testFlag(Qt::AltModifier);
    if (style == NavigationStyle::Maya) {
        if (!hasAlt) return std::nullopt;
        if (button == Qt::LeftButton) return Drag::Orbit;
        if (button == Qt::MiddleButton) return Drag::Pan;
        if (button == Qt::RightButton) return Drag::Zoom;
        return std::nullopt;
    }
    if (button != Qt::MiddleButton && !(button == Qt::LeftButton && hasAlt)) return std::nullopt;
    if (modifiers.testFlag(Qt::ShiftModifier)) return Drag::Pan;
    if (modifiers.testFlag(Qt::ControlModifier)) return Drag::Zoom;
    return Drag::Orbit;
}

Camera dragged(const Camera& camera, Drag drag, Vec2 pixels, ImageSize size) {
    const auto height = static_cast<double>(size.height);
    switch (drag) {
        case Drag::Pan: return panned(camera, pixels, size);
        case Drag::Zoom:
            return dollied(camera, std::exp(kZoomPerHeight * (pixels.y - pixels.x) / (2.0 * height)),
                           0.5 * Vec2(size.width, size.height), size);
        case Drag::Orbit: break;
    }
    return orbited(camera, -kOrbitPerHeight * pixels.x / height, kOrbitPerHeight * pixels.y / height);
}

double wheelFactor(double eighths) { return std::pow(kWheelStep, -eighths / kEighthsOfNotch); }

std::optional<ViewKey> viewKeyOf(NavigationStyle style, int key, Qt::KeyboardModifiers modifiers) {
    if (const auto number = numberKey(key, modifiers)) return number;
    if (modifiers.testFlag(Qt::ControlModifier) || modifiers.testFlag(Qt::AltModifier)) return std::nullopt;
    if (const auto arrow = arrowKey(key, modifiers.testFlag(Qt::ShiftModifier))) return arrow;
    switch (key) {
        case Qt::Key_Home: return ViewKey{.action = ViewAction::FrameAll};
        case Qt::Key_F:
        case Qt::Key_Period: return ViewKey{.action = ViewAction::FrameSelected};
        case Qt::Key_Plus:
        case Qt::Key_Equal: return ViewKey{.action = ViewAction::ZoomIn};
        case Qt::Key_Minus: return ViewKey{.action = ViewAction::ZoomOut};
        default: break;
    }
    if (key == Qt::Key_A && style == NavigationStyle::Maya) return ViewKey{.action = ViewAction::FrameAll};
    return std::nullopt;
}

}  // namespace rubble
