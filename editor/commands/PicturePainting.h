#pragma once

#include "core/fracture/GreyImage.h"
#include "core/geometry/Polygon.h"

#include <memory>

namespace rubble {

/// A round brush on a picture that is stretched over a box.
struct Brush {
    double radius = 0.1;    // m
    double strength = 0.5;  // in (0, 1]: how far one dab takes its middle towards the value; its edge is soft
    double value = 0.0;     // that is painted: 0 black, 1 white
};

/// A picture of one value, 8 bits a pixel, whose pixels are about squares over a box: `longer` of them along its longer side.
GreyImage evenPicture(const Box2& box, double value, std::uint32_t longer = 256);

/// A picture with dabs of a brush along a line, close enough to look like one stroke; what is painted becomes opaque.
GreyImage painted(GreyImage picture, const Box2& box, Vec2 from, Vec2 to, const Brush& brush);

}  // namespace rubble
