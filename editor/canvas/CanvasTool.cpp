#include "editor/canvas/CanvasTool.h"

#include "editor/canvas/GridPainting.h"
#include "editor/commands/PatternPlaces.h"
#include "editor/document/Inside.h"

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

Pattern& CanvasState::patternIn(Asset& copy) const { return ownPattern(copy, selection.inside()); }

std::optional<FragmentPath> CanvasState::brokenAt(Vec2 point) const {
    const std::uint32_t piece = pattern ? pattern->pieceAt(point) : kNone;
    const auto baked = bakes.find(selection.asset());
    if (piece == kNone || !asset() || !baked || !baked->bake) return std::nullopt;
    FragmentPath path = pathOfId(pattern->fragmentId(piece));
    if (nearestBroken(*asset(), baked->bake.get(), path) != path) return std::nullopt;
    return path;
}

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
