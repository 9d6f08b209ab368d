#pragma once

#include "editor/canvas/painting/CanvasColours.h"

#include <QPainter>
#include <QPolygonF>

namespace rubble {

/// The area of a box or lasso selection while it is dragged, in pixels.
class BoxLassoSelection {
public:
    enum class Shape { Box, Lasso };

    BoxLassoSelection(Shape shape, QPointF start) : m_shape(shape), m_path({start}) {}

    /// Drags the opposite corner of the box, or appends a point to the lasso.
    void dragTo(QPointF pixels);
    bool contains(QPointF pixels) const;
    void paint(QPainter& painter, const CanvasColours& colours) const;

private:
    QRectF box() const { return QRectF(m_path.front(), m_path.back()).normalized(); }

    Shape m_shape;
    QPolygonF m_path;  // of a box: two opposite corners
};

}  // namespace rubble
