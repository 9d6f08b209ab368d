#pragma once

#include "core/geometry/Ray.h"
#include "core/play/Session.h"

#include <optional>
#include <vector>

namespace rubble {

/// What a ray meets first within 1 km.
std::optional<CastHit> metBy(const World& world, const Ray& ray);

/// A throw from where a ray begins at what it meets first, or far along it where that is nothing: see aimedAt().
Throw thrownAlong(const Session& session, Throw thrown, const Ray& ray);
/// A blow of so many N s along a ray on what it meets first; nothing where it meets nothing.
std::optional<Hammer> blowAlong(const Session& session, double impulse, const Ray& ray);
/// A blast where a ray meets something; nothing where it meets nothing.
std::optional<Explosion> blastAlong(const Session& session, Explosion explosion, const Ray& ray);

/// A throw whose flight under a constant gravity, m/s^2, passes through a point: on the lower of the two arcs that do. Where it is
/// too slow to reach it, it is thrown straight at it.
Throw aimedAt(Throw thrown, Vec3 target, Vec3 gravity);

/// Where the middle of something thrown will fly.
struct Flight {
    std::vector<Vec3> points;    // m, one a step, the start first; the last where it is met
    std::optional<CastHit> hit;  // by what its middle meets first, of what is there now
};

/// Of a throw in the session as it is: until it meets something, at most for so many seconds.
Flight flightOf(const Session& session, const Throw& thrown, double seconds);

}  // namespace rubble
