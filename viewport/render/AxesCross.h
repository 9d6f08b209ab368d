#pragma once

#include "viewport/scene/Camera.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace rubble {

/// A round stroke in a picture, in pixels from its lower left corner.
struct Stroke {
    glm::vec4 ends{0.0f};    // from (x, y) to (z, w)
    glm::vec4 colour{1.0f};  // sRGB and opacity
    float radius = 1.0f;
};

/// A small cross of axes in the lower left corner that turns with the camera: x red, y green, z blue, lettered, those
/// that point away fainter; back to front. `scale`: pixels a point.
std::vector<Stroke> axesCross(const Camera& camera, double scale);

}  // namespace rubble
