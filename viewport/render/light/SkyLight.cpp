#include "viewport/render/light/SkyLight.h"

#include "viewport/render/light/SkyImage.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

namespace rubble {
namespace {

constexpr double kGroundInLight = 0.5;  // the part of it that bodies do not shade where it lights them
constexpr double kHorizonHeight = 0.1;  // over which the ground fades into the horizon
constexpr std::uint32_t kDiffuseWidth = 64, kReflectedWidth = 256;  // of pictures: about those of what is made of them
constexpr double kMaxShown = 6e4;                                   // radiance: nearly the largest half float

using Radiance = std::function<Vec3(Vec3)>;

SkyLight lightOf(const Sky& sky, const Radiance& diffuse, const Radiance& mirrored) {
    SkyLight light{.sky = sky};
    light.diffuse = diffuseLight(diffuse);
    light.sunOnGround = std::max(sky.sunDirection.y, 0.0) * sky.sunLight;
    light.skyOnGround = valueFor(light.diffuse, {0.0, 1.0, 0.0});
    light.ground = kGroundInLight * sky.groundAlbedo * (light.sunOnGround + light.skyOnGround);
    light.reflections = reflectionMap([&](Vec3 direction) {
        const double below = std::clamp(-direction.y / kHorizonHeight, 0.0, 1.0);
        return glm::mix(mirrored(direction), light.ground, below);
    });
    return light;
}

void multiply(RadianceImage& image, double factor) {
    for (std::array<float, 3>& pixel : image.pixels) {
        for (float& value : pixel) value = static_cast<float>(std::min(factor * static_cast<double>(value), kMaxShown));
    }
}

/// The mean of the rows above the horizon from one part of their number to another, counted from the zenith.
Vec3 meanOfRows(const RadianceImage& image, double first, double last) {
    const double rows = rowsAboveHorizon(image);
    const auto from = static_cast<std::uint32_t>(first * rows), to = static_cast<std::uint32_t>(std::ceil(last * rows));
    Vec3 sum(0.0);
    double angles = 0.0;
    for (std::uint32_t row = from; row < to; ++row) {
        const double angle = solidAngle(image, row);
        for (std::uint32_t x = 0; x < image.width; ++x) {
            const std::array<float, 3>& pixel = image.pixels[std::size_t{row} * image.width + x];
            sum += angle * Vec3(pixel[0], pixel[1], pixel[2]);
        }
        angles += angle * image.width;
    }
    return sum / angles;
}

}  // namespace

SkyLight skyLightOf(const Sky& sky) {
    const auto radiance = [&](Vec3 direction) { return skyRadiance(sky, direction); };
    return lightOf(sky, radiance, radiance);
}

SkyLight skyLightOf(RadianceImage image, const Vec3& groundAlbedo) {
    static const double studio = luminance(meanRadiance(skyLightOf(skyOf(SkyPreset::Studio, Theme::Light))));
    const double factor = studio / luminance(meanRadiance(image));
    Sky sky{.groundAlbedo = groundAlbedo};
    if (const std::optional<DirectionalLight> key = takeKeyLight(image)) {
        sky.sunDirection = key->direction;
        sky.sunLight = factor * key->light;
        sky.sunRadius = key->radius;
    }
    multiply(image, factor);
    sky.zenith = meanOfRows(image, 0.0, 0.4);
    sky.horizon = meanOfRows(image, 0.9, 1.0);
    SkyLight light = lightOf(sky, SkySampler(image, kDiffuseWidth), SkySampler(image, kReflectedWidth));
    light.background = std::make_shared<const RadianceImage>(std::move(image));
    return light;
}

/// The first harmonic is half the mean over the hemisphere; a surface that faces the sun reflects twice its mean.
Vec3 meanRadiance(const SkyLight& light) { return 2.0 * light.diffuse.coefficients[0] + 0.5 * light.sky.sunLight; }

}  // namespace rubble
