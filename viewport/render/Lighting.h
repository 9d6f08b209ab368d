#pragma once

#include "core/geometry/predicates/Vec.h"
#include "viewport/render/RenderSettings.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace rubble {

/// The colours of a theme for everything but the bodies. sRGB.
struct Environment {
    glm::vec4 backgroundTop, backgroundBottom, grid, hulls, wires;
    float shadowStrength = 0.0f;      // on the ground
    glm::vec3 zenith, horizon, soil;  // outdoors
    float dustLight = 1.0f;           // brightness of dust
};
Environment environmentOf(Theme theme);

/// The light directions and the subpixel offset of one of many samples. Their mean is lit by the whole sky and an area
/// key light, and is antialiased. The sequence is the same on every machine.
struct LightSample {
    int index = 0;
    Vec3 keyDirection;  // towards the light, length 1
    Vec3 skyDirection;  // uniform over the upper hemisphere
    Vec2 pixelOffset;   // in [-0.5, 0.5)
};
/// Source: Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018.
LightSample lightSample(int index);

/// The direction towards the centre of the key light: left, front and above.
Vec3 keyDirection();

}  // namespace rubble
