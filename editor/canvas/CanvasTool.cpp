#include "editor/canvas/CanvasTool.h"

#include "editor/canvas/GridPainting.h"

namespace rubble {

namespace {

constexpr double kNudge = 1.0;  // pixels
constexpr double kBigNudge = 10.0;

std::optional<Vec2> directionOf(int key) {
    switch (key) {
        case Qt::Key_Left: return Vec2(-1.0, 0.0);
        case Qt::Key_Right: return Vec2(1.0, 0.0);
        case Qt::Key_Up: return Vec2(0.0, 1.0);
        case Qt::Key_Down: return Vec2(0.0, -1.0);
        default: return std::nullopt;
    }
}

}  // namespace

std::optional<Vec2> nudgeOf(const QKeyEvent& event, const CanvasState& state) {
    const std::optional<Vec2> direction = directionOf(event.key());
    if (!direction) return std::nullopt;
    const bool isBig = event.modifiers().testFlag(Qt::ShiftModifier);
    if (state.isSnapping && !isBig) return *direction * gridStep(state.view);
    return *direction * ((isBig ? kBigNudge : kNudge) / state.view.scale);
}

quint64 CanvasTool::nudgeStroke(bool isRepeated) {
    if (!isRepeated || m_nudgeStroke == 0) m_nudgeStroke = m_state.document.newStroke();
    return m_nudgeStroke;
}

}  // namespace rubble
