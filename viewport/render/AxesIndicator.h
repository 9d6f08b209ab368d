#pragma once

#include "viewport/scene/Camera.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace rubble {

/// A line with round caps in the image, in pixels from its lower left corner.
struct ScreenLine {
    glm::vec4 ends{0.0f};    // from (x, y) to (z, w)
    glm::vec4 colour{1.0f};  // sRGB and opacity
    float radius = 1.0f;
};

/// The axes indicator in the lower left corner, which rotates with the camera: x red, y green, z blue, labelled; axes
/// that point away are fainter. Sorted back to front. `scale`: pixels per point.
std::vector<ScreenLine> axesIndicator(const Camera& camera, double scale);

}  // namespace rubble
