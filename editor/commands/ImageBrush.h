#pragma once

#include "core/fracture/sampling/GreyImage.h"
#include "core/geometry/polygon/Polygon.h"

#include <memory>

namespace rubble {

/// A round brush for an image that is stretched over a box.
struct Brush {
    double radius = 0.1;    // m
    double strength = 0.5;  // in (0, 1]: opacity of a dab at its centre; the edge is soft
    double value = 0.0;     // painted: 0 black, 1 white
};

/// An image of one value, 8 bits per pixel, with nearly square pixels over a box: `longer` of them along its longer
/// side.
GreyImage uniformImage(const Box2& box, double value, std::uint32_t longer = 256);

/// Paints dabs along a line, close enough to look continuous. Painted pixels become opaque.
GreyImage painted(GreyImage picture, const Box2& box, Vec2 from, Vec2 to, const Brush& brush);

}  // namespace rubble
