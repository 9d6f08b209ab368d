#pragma once

namespace rubble {

/// The radius of a brush on screen, from 3 to 400 pixels.
class BrushSize {
public:
    double radiusPixels() const { return m_radiusPixels; }
    void setRadiusPixels(double radius);
    /// Enlarges it by a number of steps, a quarter each: presses of a key or notches of the wheel; negative: reduces
    /// it.
    void step(double steps);

private:
    double m_radiusPixels = 30.0;
};

}  // namespace rubble
