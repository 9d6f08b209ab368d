#pragma once

#include "core/geometry/polygon/PolygonFaults.h"
#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>

#include <optional>
#include <vector>

namespace rubble {

/// A ring that is drawn point by point; the pen is the position of its next point.
class OutlineDraft {
public:
    /// `container`: the outline that the ring becomes a hole of; none if it becomes an outline itself.
    explicit OutlineDraft(std::optional<Polygon> container) : m_container(std::move(container)) {}

    const Ring& points() const { return m_points; }
    void movePen(Vec2 position) { m_pen = position; }
    Vec2 pen() const { return m_pen; }
    /// Adds a point at the pen; does nothing if the last point is there.
    void add();
    /// False if there is no point.
    bool removeLast();
    /// Whether the pen is within `radius` metres of the first point and there are enough points to close the ring.
    bool closesAt(double radius) const;

    /// The outline with the ring closed.
    Polygon closed() const;
    void paint(QPainter& painter, const CanvasView& view, const CanvasColours& colours) const;

private:
    Polygon with(const Ring& ring) const;
    std::vector<PolygonFault> openFaults(const Polygon& outline) const;

    std::optional<Polygon> m_container;
    Ring m_points;
    Vec2 m_pen{0.0, 0.0};
};

}  // namespace rubble
