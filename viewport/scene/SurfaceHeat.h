#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/vec4.hpp>

namespace rubble {

struct BodyForecast;
struct ForecastProjectile;

/// The projectile of a break forecast in the format of the shaders; the same for all bodies of a scene.
struct HeatSource {
    glm::vec4 from{0.0f};     // m, relative to RenderScene::origin; w: 1 / its mass
    glm::vec4 gravity{0.0f};  // m/s^2; w: its initial speed squared
};

/// The coefficients of a body's break forecast, from which the shader computes BodyForecast::at() for every pixel. All
/// vectors are in scene axes.
struct SurfaceHeat {
    glm::vec4 centre{0.0f};           // m, relative to RenderScene::origin; w: 1 / its mass
    glm::vec4 velocity{0.0f};         // m/s; w: 1 / its threshold
    glm::vec4 angularVelocity{0.0f};  // rad/s; w: 1 + the restitution of the pair
    glm::vec4 inertia{0.0f};          // of the inverse inertia: xx, yy, zz; w: unused
    glm::vec4 products{
        0.0f};  // of the inverse inertia: xy, xz, yz; w: under the momentum rule its own momentum, N·s; else -1
};

HeatSource heatSource(const ForecastProjectile& projectile, Vec3 origin);
SurfaceHeat surfaceHeat(const BodyForecast& forecast, Vec3 origin);

}  // namespace rubble
