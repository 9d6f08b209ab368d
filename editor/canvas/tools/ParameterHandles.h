#pragma once

#include "editor/canvas/tools/CanvasTool.h"

#include "core/fracture/pattern/PatternKind.h"

namespace rubble {

/// A handle for a layer parameter: a point, such as the centre of a radial layer, or the angle of its cuts or grain, as
/// seen from the centre of the asset.
struct ParameterHandle {
    Id layer = 0;
    const LayerParameter* parameter = nullptr;
    Vec2 position{0.0, 0.0};         // m
    std::optional<Vec2> pivot = {};  // m; only for angles
};
/// The handles of all enabled layers of the asset.
std::vector<ParameterHandle> parameterHandles(const Asset& asset);

/// Shows parameter handles on a canvas and lets the user drag them; used by a tool before its own input.
class ParameterHandles {
public:
    explicit ParameterHandles(const CanvasState& state) : m_state(state) {}

    /// True if a handle was grabbed; it follows move() until endDrag().
    bool press(const CanvasPointer& pointer);
    /// `hasMoved`: the pointer moved farther than in a click.
    void move(const CanvasPointer& pointer, bool hasMoved);
    bool isDragging() const { return m_drag.has_value(); }
    bool isHovered() const { return m_hovered.has_value(); }
    /// Ends the drag and keeps the value.
    void endDrag() { m_drag.reset(); }
    /// Cancels the drag and restores the value; false if there is none.
    bool cancel();
    void paint(QPainter& painter, const CanvasColours& colours) const;
    /// The name of the hovered handle: "Centre of radial"; empty without one.
    QString text() const;

private:
    struct Drag {
        Asset before;
        ParameterHandle handle;
        quint64 mergeKey = 0;
    };
    std::optional<ParameterHandle> handleAt(QPointF pixels) const;
    void push(const Drag& drag, Vec2 position);

    const CanvasState& m_state;
    std::optional<Drag> m_drag;
    std::optional<ParameterHandle> m_hovered;
};

}  // namespace rubble
