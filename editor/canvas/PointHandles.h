#pragma once

#include "editor/canvas/CanvasTool.h"

#include "core/fracture/PatternKind.h"

namespace rubble {

/// A point that a layer has as a parameter, as the centre of a radial one; or one that stands for the angle in which its cuts or its
/// grain run, seen from the middle of the asset.
struct PointHandle {
    Id layer = 0;
    const LayerParameter* parameter = nullptr;
    Vec2 position{0.0, 0.0};         // m
    std::optional<Vec2> pivot = {};  // m: of an angle
};
/// Those of all layers of the asset that are on.
std::vector<PointHandle> pointHandles(const Asset& asset);

/// Shows such points on a canvas and lets them be dragged: what a tool does first of all.
class PointHandles {
public:
    explicit PointHandles(CanvasState& state) : m_state(state) {}

    /// True where a point was taken, which then follows move() until it is let go of.
    bool press(const CanvasPointer& pointer);
    /// `hasMoved`: farther than a click may.
    void move(const CanvasPointer& pointer, bool hasMoved);
    bool isHeld() const { return m_drag.has_value(); }
    bool isPointedAt() const { return m_hovered.has_value(); }
    /// Leaves the point where it is now.
    void letGo() { m_drag.reset(); }
    /// Puts it back; false where none is held.
    bool cancel();
    void paint(QPainter& painter, const CanvasColours& colours) const;
    /// What the point that is pointed at belongs to: "Centre of radial".
    QString text() const;

private:
    struct Drag {
        Asset before;
        PointHandle handle;
        quint64 stroke = 0;
    };
    std::optional<PointHandle> handleAt(QPointF pixels) const;
    void push(const Drag& drag, Vec2 position);

    CanvasState& m_state;
    std::optional<Drag> m_drag;
    std::optional<PointHandle> m_hovered;
};

}  // namespace rubble
