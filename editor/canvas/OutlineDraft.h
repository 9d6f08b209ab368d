#pragma once

#include "core/geometry/PolygonFaults.h"
#include "editor/canvas/CanvasColours.h"
#include "editor/canvas/CanvasView.h"

#include <QPainter>

#include <optional>
#include <vector>

namespace rubble {

/// A ring that is being drawn point by point, with the pen where its next point would be.
class OutlineDraft {
public:
    /// `around`: the outline that it becomes a hole of; none where it becomes an outline itself.
    explicit OutlineDraft(std::optional<Polygon> around) : m_around(std::move(around)) {}

    const Ring& points() const { return m_points; }
    void movePen(Vec2 position) { m_pen = position; }
    Vec2 pen() const { return m_pen; }
    /// Adds the pen's place; a second time in a row does nothing.
    void add();
    /// False where there is none left.
    bool removeLast();
    /// True where the first point is nearer to the pen than `reach` metres, and there are enough points to close the ring.
    bool wouldClose(double reach) const;

    /// What it is when it is closed.
    Polygon closed() const;
    void paint(QPainter& painter, const CanvasView& view, const CanvasColours& colours) const;

private:
    Polygon with(const Ring& ring) const;
    std::vector<PolygonFault> openFaults(const Polygon& outline) const;

    std::optional<Polygon> m_around;
    Ring m_points;
    Vec2 m_pen{0.0, 0.0};
};

}  // namespace rubble
