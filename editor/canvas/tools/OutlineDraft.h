#pragma once

#include "core/geometry/polygon/PolygonFaults.h"
#include "editor/canvas/painting/CanvasColours.h"
#include "editor/canvas/painting/CanvasView.h"

#include <QPainter>

#include <vector>

namespace rubble {

/// The kinds of shapes that can be drawn.
enum class DraftShape {
    Polygon,    // by its corners
    Rectangle,  // by two opposite corners
    Circle,     // by its centre and a point on it
};

/// A shape that is drawn point by point; the pen is the position of its next point.
class OutlineDraft {
public:
    explicit OutlineDraft(DraftShape shape) : m_shape(shape) {}

    DraftShape shape() const { return m_shape; }
    const Ring& points() const { return m_points; }
    void movePen(Vec2 position) { m_pen = position; }
    Vec2 pen() const { return m_pen; }
    /// Adds a point at the pen; does nothing if the last point is there.
    void add();
    /// False if there is no point.
    bool removeLast();
    /// Whether the pen is within `radius` metres of the first corner of a polygon that has enough corners.
    bool closesAt(double radius) const;
    /// Whether a rectangle or a circle has its two points.
    bool isComplete() const { return m_shape != DraftShape::Polygon && m_points.size() == 2; }

    /// The closed ring of the points.
    Ring ring() const { return ringOf(m_points); }
    void paint(QPainter& painter, const CanvasView& view, const CanvasColours& colours) const;

private:
    Ring ringOf(const Ring& points) const;
    std::vector<PolygonFault> openFaults(const Polygon& outline) const;

    DraftShape m_shape;
    Ring m_points;
    Vec2 m_pen{0.0, 0.0};
};

}  // namespace rubble
