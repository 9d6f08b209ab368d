#include "core/play/Aim.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFarthestAim = 1000.0;  // m: what a ray meets beyond it is not aimed at
constexpr double kNothingMet = 30.0;     // m: where a throw goes that is aimed at nothing

}  // namespace

std::optional<CastHit> metBy(const World& world, const Ray& ray) {
    return world.castRay(ray.from, ray.at(kFarthestAim));
}

Throw thrownAlong(const Session& session, Throw thrown, const Ray& ray) {
    const std::optional<CastHit> hit = metBy(session.world(), ray);
    thrown.from = ray.from;
    return aimedAt(thrown, hit ? hit->point : ray.at(kNothingMet), session.world().gravity());
}

std::optional<Hammer> blowAlong(const Session& session, double impulse, const Ray& ray) {
    const std::optional<CastHit> hit = metBy(session.world(), ray);
    if (!hit) return std::nullopt;
    return Hammer{hit->point, impulse * ray.direction};
}

std::optional<Explosion> blastAlong(const Session& session, Explosion explosion, const Ray& ray) {
    const std::optional<CastHit> hit = metBy(session.world(), ray);
    if (!hit) return std::nullopt;
    explosion.at = hit->point;
    return explosion;
}

/// Source: t^2 of the arcs through d at speed v solves g^2/4 t^4 - (d.g + v^2) t^2 + d^2 = 0; the smaller root in the form that
/// does not cancel, which holds without gravity, too.
Throw aimedAt(Throw thrown, Vec3 target, Vec3 gravity) {
    thrown.to = target;
    const Vec3 way = target - thrown.from;
    const double half = glm::dot(way, gravity) + thrown.speed * thrown.speed;
    const double reach = half * half - glm::dot(gravity, gravity) * glm::dot(way, way);
    if (half <= 0.0 || reach < 0.0) return thrown;
    const double squaredTime = 2.0 * glm::dot(way, way) / (half + std::sqrt(reach));
    thrown.to = target - 0.5 * squaredTime * gravity;
    return thrown;
}

Flight flightOf(const Session& session, const Throw& thrown, double seconds) {
    const Vec3 way = thrown.to - thrown.from, gravity = session.world().gravity();
    const double length = std::sqrt(glm::dot(way, way));
    Flight flight{.points = {thrown.from}};
    if (!(length > 0.0)) return flight;
    const Vec3 velocity = (thrown.speed / length) * way;
    const std::uint64_t steps = stepOf(seconds, session.stepLength());
    for (std::uint64_t step = 1; step <= steps && !flight.hit; ++step) {
        const double time = static_cast<double>(step) * session.stepLength();
        const Vec3 next = thrown.from + time * velocity + 0.5 * time * time * gravity;
        flight.hit = session.world().castRay(flight.points.back(), next);
        flight.points.push_back(flight.hit ? flight.hit->point : next);
    }
    return flight;
}

}  // namespace rubble
