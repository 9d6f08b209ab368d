#pragma once

#include "core/geometry/Vec.h"
#include "viewport/render/RenderSettings.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace rubble {

/// The colours that a theme gives to what is around the scene. sRGB.
struct Surroundings {
    glm::vec4 backgroundTop, backgroundBottom, grid, hulls, wires;
    float shadowStrength = 0.0f;      // on the ground
    glm::vec3 zenith, horizon, soil;  // outdoors
    float dustLight = 1.0f;           // how bright dust is
};
Surroundings surroundingsOf(Theme theme);

/// From where one of many samples is lit and through which part of a pixel it is seen. Their mean is lit by the whole
/// sky and by a key light as wide as a lamp, without jags; sample by sample the same on every machine.
struct LightSample {
    Vec3 keyDirection;  // towards the light, length 1
    Vec3 skyDirection;  // evenly over the half sphere above
    Vec2 pixelOffset;   // in [-0.5, 0.5)
};
/// Source: Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018.
LightSample lightSample(int index);

/// Towards the middle of the key light: from the left, the front and above.
Vec3 keyDirection();

}  // namespace rubble
