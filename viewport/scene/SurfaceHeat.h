#pragma once

#include "core/geometry/Vec.h"

#include <glm/vec4.hpp>

namespace rubble {

struct BodyForecast;
struct ForecastMissile;

/// From where the heat of surfaces comes: what is thrown, as shaders take it. The same for all bodies of a scene.
struct HeatSource {
    glm::vec4 from{0.0f};     // m, relative to RenderScene::origin; w: 1 / its mass
    glm::vec4 gravity{0.0f};  // m/s^2; w: the square of its speed at the start
};

/// What the heat of a body's surface follows from at every point of it, in closed form: BodyForecast::at() as shaders take it.
/// All vectors are of the scene's axes.
struct SurfaceHeat {
    glm::vec4 centre{0.0f};    // m, relative to RenderScene::origin; w: 1 / its mass
    glm::vec4 velocity{0.0f};  // m/s; w: 1 / its threshold
    glm::vec4 spin{0.0f};      // rad/s; w: 1 + the restitution between it and what is thrown
    glm::vec4 inertia{0.0f};   // of the inverse: xx, yy, zz; w: nothing
    glm::vec4 products{0.0f};  // of the inverse: xy, xz, yz; w: by the momentum rule its own momentum, N s; else -1
};

HeatSource heatSource(const ForecastMissile& missile, Vec3 origin);
SurfaceHeat surfaceHeat(const BodyForecast& forecast, Vec3 origin);

}  // namespace rubble
