#include "viewport/render/light/SkyLight.h"

#include <glm/common.hpp>

#include <algorithm>

namespace rubble {
namespace {

constexpr double kGroundInLight = 0.5;  // the part of it that bodies do not shade where it lights them
constexpr double kHorizonHeight = 0.1;  // over which the ground fades into the horizon

}  // namespace

SkyLight skyLightOf(const Sky& sky) {
    SkyLight light{.sky = sky};
    light.diffuse = diffuseLight([&](Vec3 direction) { return skyRadiance(sky, direction); });
    light.sunOnGround = std::max(sky.sunDirection.y, 0.0) * sky.sunLight;
    light.skyOnGround = valueFor(light.diffuse, {0.0, 1.0, 0.0});
    light.ground = kGroundInLight * sky.groundAlbedo * (light.sunOnGround + light.skyOnGround);
    light.reflections = reflectionMap([&](Vec3 direction) {
        const double below = std::clamp(-direction.y / kHorizonHeight, 0.0, 1.0);
        return glm::mix(skyRadiance(sky, direction), light.ground, below);
    });
    return light;
}

}  // namespace rubble
