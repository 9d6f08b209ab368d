#include "viewport/scene/SurfaceHeat.h"

#include "core/play/analysis/Forecast.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

glm::vec4 row(Vec3 v, double w) { return glm::vec4(glm::dvec4(v, w)); }

}  // namespace

HeatSource heatSource(const ForecastProjectile& projectile, Vec3 origin) {
    return {.from = row(projectile.from - origin, 1.0 / projectile.mass),
            .gravity = row(projectile.gravity, projectile.speed * projectile.speed)};
}

SurfaceHeat surfaceHeat(const BodyForecast& forecast, Vec3 origin) {
    const MovingMass& mass = forecast.mass;
    const Mat3& inverse = mass.inverseInertia;
    return {.centre = row(mass.centre - origin, mass.inverseMass),
            .velocity = row(mass.velocity, 1.0 / forecast.threshold),
            .angularVelocity =
                row(mass.angularVelocity, 1.0 + std::max(forecast.restitution, forecast.projectile.restitution)),
            .inertia = row({inverse[0][0], inverse[1][1], inverse[2][2]}, 0.0),
            .products = row({inverse[0][1], inverse[0][2], inverse[1][2]},
                            forecast.rule == DamageRule::Momentum ? forecast.ownMomentum() : -1.0)};
}

}  // namespace rubble
