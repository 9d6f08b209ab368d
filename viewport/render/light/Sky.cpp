#include "viewport/render/light/Sky.h"

#include "core/base/math/Power.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kLampEdge = 0.35;  // of a lamp's radius, over which its edge fades

/// A key light, two soft boxes and one from behind, in a room of even light.
Sky studio(Theme theme) {
    return {.sunDirection = glm::normalize(Vec3(-0.45, 0.95, 0.62)),
            .sunLight = {0.95, 0.91, 0.86},
            .sunRadius = 0.045,  // soft shadows whose casters remain recognizable
            .zenith = {0.29, 0.30, 0.32},
            .horizon = {0.34, 0.35, 0.37},
            .groundAlbedo = Vec3(theme == Theme::Dark ? 0.22 : 0.42),
            .lamps = {{glm::normalize(Vec3(0.2, 1.0, 0.1)), 0.7, Vec3(0.46, 0.48, 0.50)},
                      {glm::normalize(Vec3(0.95, 0.35, 0.45)), 0.5, Vec3(0.66, 0.70, 0.77)},
                      {glm::normalize(Vec3(0.4, 0.4, -0.9)), 0.35, Vec3(1.1, 1.0, 0.9)}}};
}

Sky overcast() {
    return {.sunDirection = glm::normalize(Vec3(-0.4, 1.0, 0.5)),
            .sunLight = {0.40, 0.40, 0.40},
            .sunRadius = 0.12,
            .zenith = {0.90, 0.94, 1.00},
            .horizon = {0.68, 0.71, 0.74},
            .groundAlbedo = kConcreteAlbedo};
}

Sky morning() {
    return {.sunDirection = glm::normalize(Vec3(-0.78, 0.48, 0.55)),
            .sunLight = {1.50, 1.22, 0.90},
            .sunRadius = 0.018,
            .zenith = {0.20, 0.32, 0.56},
            .horizon = {0.64, 0.67, 0.69},
            .glow = {0.70, 0.46, 0.24},
            .glowSharpness = 7.0,
            .groundAlbedo = {0.35, 0.345, 0.33}};
}

Sky evening() {
    return {.sunDirection = glm::normalize(Vec3(-0.80, 0.42, 0.42)),
            .sunLight = {1.60, 1.00, 0.54},
            .sunRadius = 0.022,
            .zenith = {0.13, 0.18, 0.29},
            .horizon = {0.44, 0.37, 0.36},
            .glow = {1.10, 0.45, 0.12},
            .glowSharpness = 8.0,
            .groundAlbedo = {0.40, 0.395, 0.39}};
}

/// The key light is a lamp; so is what lights the other side.
Sky night() {
    return {.sunDirection = glm::normalize(Vec3(-0.6, 0.75, 0.62)),
            .sunLight = {0.80, 0.70, 0.57},
            .sunRadius = 0.05,
            .zenith = {0.060, 0.070, 0.092},
            .horizon = {0.100, 0.112, 0.136},
            .groundAlbedo = {0.20, 0.20, 0.20},
            .lamps = {{glm::normalize(Vec3(0.9, 0.5, 0.3)), 0.5, Vec3(0.34, 0.43, 0.60)},
                      {glm::normalize(Vec3(-0.9, 0.25, -0.3)), 0.3, Vec3(0.85, 0.56, 0.28)},
                      {glm::normalize(Vec3(0.3, 0.3, -0.9)), 0.3, Vec3(0.80, 0.56, 0.30)}}};
}

}  // namespace

Sky skyOf(SkyPreset preset, Theme theme) {
    switch (preset) {
        case SkyPreset::Overcast: return overcast();
        case SkyPreset::Morning: return morning();
        case SkyPreset::Evening: return evening();
        case SkyPreset::Night: return night();
        case SkyPreset::Studio: break;
    }
    return studio(theme);
}

/// As skyRadiance() in sky_radiance.glsl.
Vec3 backgroundRadiance(const Sky& sky, Vec3 direction) {
    const double low = 1.0 - std::max(direction.y, 0.0);
    const double near = power(2.0, sky.glowSharpness * (glm::dot(direction, sky.sunDirection) - 1.0));
    return glm::mix(sky.zenith, sky.horizon, low * low * low) + sky.glow * near;
}

Vec3 skyRadiance(const Sky& sky, Vec3 direction) {
    Vec3 radiance = backgroundRadiance(sky, direction);
    for (const SkyLamp& lamp : sky.lamps) {
        const double facing = glm::dot(direction, lamp.direction);
        const double aside = std::sqrt(std::max(1.0 - facing * facing, 0.0)) / lamp.radius;
        const double cover = facing > 0.0 ? 1.0 - glm::smoothstep(1.0 - kLampEdge, 1.0, aside) : 0.0;
        radiance += cover * lamp.radiance;
    }
    return radiance;
}

}  // namespace rubble
