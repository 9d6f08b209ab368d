#pragma once

#include "core/base/image/RadianceImage.h"
#include "core/geometry/predicates/Vec.h"
#include "viewport/render/light/SkyImage.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rubble::test {

/// The picture of a sky.
inline RadianceImage skyImage(std::uint32_t width, const std::function<Vec3(Vec3)>& radiance) {
    RadianceImage image{width, width / 2, {}};
    for (std::uint32_t y = 0; y < image.height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const Vec3 value = radiance(directionInSky({(x + 0.5) / width, (y + 0.5) / image.height}));
            image.pixels.push_back(
                {static_cast<float>(value.x), static_cast<float>(value.y), static_cast<float>(value.z)});
        }
    }
    return image;
}

/// How much of a pixel around a direction a disc of light covers, roughly, in the picture of a sky.
inline double discCover(std::uint32_t width, Vec3 direction, Vec3 centre, double radius) {
    const double pixel = 2.0 * M_PI / width, apart = 2.0 * std::asin(0.5 * glm::length(direction - centre));
    return std::clamp((radius - apart) / pixel + 0.5, 0.0, 1.0);
}

}  // namespace rubble::test
