#pragma once

#include "viewport/render/AxesCross.h"

#include <string>

namespace rubble {

/// A length that is easy to read, and how it is written: 1, 2 or 5 times a power of ten, the largest up to `most` m.
struct RoundLength {
    double metres = 1.0;
    std::string text;  // "50 cm"
};
RoundLength roundLength(double most);

/// A bar in the lower right corner that is as long as a round length where the camera's target is, with that length written
/// over it. `scale`: pixels a point.
std::vector<Stroke> scaleBar(const Camera& camera, PictureSize size, double scale, glm::vec3 colour, glm::vec3 halo);

}  // namespace rubble
