#pragma once

#include "core/play/breaking/MovingMass.h"
#include "core/play/session/Session.h"

namespace rubble {

/// A projectile in a forecast: a mass with central impacts only, so that it does not rotate.
struct ForecastProjectile {
    double mass = 0.0;         // kg
    double restitution = 0.0;  // in [0, 1]
    Vec3 from{0.0, 0.0, 0.0};
    double speed = 0.0;           // m/s, at the start
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s^2
};

/// How close a throw would come to breaking a body, for any target point on its surface.
struct BodyForecast {
    std::uint32_t body = 0;  // its number
    double threshold = 0.0;  // N·s; infinite if it does not break: then all values are 0
    double restitution = 0.0;
    MovingMass mass;  // with its current motion
    ForecastProjectile projectile;
    DamageRule rule = DamageRule::Impact;
    double largest = 0.0;         // impact ÷ threshold on its surface; it breaks from 1 on
    Vec3 weakest{0.0, 0.0, 0.0};  // where the largest is, in the world

    /// The damage from its own motion by the momentum rule, N·s.
    double ownMomentum() const;
    /// Impact ÷ threshold at a point of its surface with its outward normal, in the world.
    double at(Vec3 point, Vec3 normal) const;
};

/// The impact of a throw on every body, for any target point on their surfaces, relative to their thresholds. In closed
/// form, without simulation: the projectile flies straight from its start to the point, its speed changed by the work
/// of gravity, and nothing is in the way. 0 on faces that point away from it, and where it is too slow to do damage or
/// to arrive.
///
/// This is an upper bound. A real projectile usually hits off-centre, which makes it rotate and reduces the impact:
/// much so for the corner of a cube against a heavy body.
///
/// Errors: BadInput for an invalid throw: see projectileBody(), or if its asset is not in the scene.
Result<std::vector<BodyForecast>> breakForecast(const Session& session, const Throw& thrown);

}  // namespace rubble
