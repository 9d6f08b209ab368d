#pragma once

#include <QColor>

#include <QPainter>

namespace rubble {

/// The radius of a brush on the canvas or in the 3D view, from 3 to 400 pixels, and the rings that show it.
class BrushSize {
public:
    double radiusPixels() const { return m_radiusPixels; }
    void setRadiusPixels(double radius);
    /// Enlarges it by a number of steps, a quarter each: presses of a key or notches of the wheel; negative: reduces
    /// it.
    void step(double steps);

    /// A ring of a part of the radius around a position, dashed for a brush that erases.
    void paintRing(QPainter& painter, QPointF centre, double part, const QColor& colour, const QColor& halo,
                   bool isErasing) const;

private:
    double m_radiusPixels = 30.0;
};

}  // namespace rubble
