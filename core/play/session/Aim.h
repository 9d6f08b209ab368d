#pragma once

#include "core/geometry/hull/Ray.h"
#include "core/play/session/Session.h"

#include <optional>
#include <vector>

namespace rubble {

/// The first body that a ray hits within 1 km.
std::optional<CastHit> firstHit(const World& world, const Ray& ray);

/// The speed of a throw along a ray, m/s, that reaches its first hit within 0.4 s, or a point far along it without one.
/// Where that is slower, three times the speed at which a central impact breaks the body that is hit: light projectiles
/// are thrown faster. At most 100 m/s, which reaches 1 km.
double reachingSpeed(const Session& session, const Throw& thrown, const Ray& ray);

/// A throw from the start of a ray at the ray's first hit, or at a point far along it: see aimedAt().
Throw throwAlong(const Session& session, Throw thrown, const Ray& ray);
/// A hammer blow of `impulse` N·s along a ray on its first hit, on a patch of `radius` m (see Hammer::radius); nothing
/// without a hit.
std::optional<Hammer> hammerAlong(const Session& session, double impulse, const Ray& ray,
                                  std::optional<double> radius = std::nullopt);
/// A blast at the first hit of a ray, off the surface by a tenth of its radius, or in the middle of a narrower
/// gap; nothing without a hit.
std::optional<Blast> blastAlong(const Session& session, Blast blast, const Ray& ray);

/// A throw whose trajectory under constant gravity, m/s², passes through a point, on the lower of the two possible
/// arcs. If it is too slow to reach the point, it is thrown straight at it.
Throw aimedAt(Throw thrown, Vec3 target, Vec3 gravity);

/// The predicted trajectory of a projectile's centre.
struct Trajectory {
    std::vector<Vec3> points;    // m, one per step, the start first; the last at the hit
    std::optional<CastHit> hit;  // the first of the centre, with the bodies as they are now
};

/// The trajectory of a throw in the session's current state, up to the first hit or for at most `seconds`.
Trajectory trajectoryOf(const Session& session, const Throw& thrown, double seconds);

}  // namespace rubble
