#pragma once

#include "core/play/MovingMass.h"
#include "core/play/Session.h"

namespace rubble {

/// What is thrown, as a forecast sees it: a mass that is struck centrally, so that nothing turns it.
struct ForecastMissile {
    double mass = 0.0;         // kg
    double restitution = 0.0;  // in [0, 1]
    Vec3 from{0.0, 0.0, 0.0};
    double speed = 0.0;           // m/s, at the start
    Vec3 gravity{0.0, 0.0, 0.0};  // m/s^2
};

/// How near a throw would come to breaking a body, wherever it were aimed at.
struct BodyForecast {
    std::uint32_t body = 0;  // its number
    double threshold = 0.0;  // N s; infinite where it does not break: then all is 0
    double restitution = 0.0;
    MovingMass mass;  // as it moves at that moment
    ForecastMissile missile;
    DamageRule rule = DamageRule::Impact;
    double largest = 0.0;         // of its surface: the largest impact ÷ threshold, at 1 and above it breaks
    Vec3 weakest{0.0, 0.0, 0.0};  // the place of it, in the world

    /// What its own motion does to it by the momentum rule, N s.
    double ownMomentum() const;
    /// Impact ÷ threshold at a point of its surface, in the world, with the outward normal there: what a viewport colours.
    double at(Vec3 point, Vec3 normal) const;
};

/// What a throw would do to every body that is there, were it aimed anywhere on their surfaces: impact ÷ threshold in closed form,
/// nothing is simulated. The missile flies straight from its start to the point, faster or slower by the work of gravity
/// over the way, as if nothing stood between. 0 on faces that look away from it, where it comes too slowly to hurt, or
/// cannot come up to.
///
/// A real missile is met off its centre more often than not, which turns it and makes its impact less: a cube's at a
/// corner by as much as a body hardly heavier than it allows. So a forecast is the most that a throw does.
///
/// Errors: BadInput where the throw has no use: see missile(), or its asset is not of the scene.
Result<std::vector<BodyForecast>> breakForecast(const Session& session, const Throw& thrown);

}  // namespace rubble
