#include "core/play/session/Aim.h"

#include "core/play/breaking/MovingMass.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMaxDistance = 1000.0;    // m: farther hits are ignored
constexpr double kDefaultDistance = 30.0;  // m: of the target without a hit
constexpr double kReachingTime = 0.4;      // s, of the flight: short enough to see where it goes
constexpr double kBreakMargin = 3.0;       // since most impacts are not central
constexpr double kStandOff = 0.1;          // of the radius of a blast: one in a surface has no effect on it
constexpr double kMinReachingSpeed = 1.0, kMaxReachingSpeed = 100.0;  // m/s

/// The mass of a projectile, kg; 0 if its asset is not in the scene.
double projectileMass(const PlayScene& scene, const Throw& thrown) {
    if (thrown.kind != ProjectileKind::Asset) return thrown.mass;
    const auto asset = scene.assets.find({thrown.asset});
    if (asset == scene.assets.end()) return 0.0;
    const Material* material = findMaterial(scene.project, findAsset(scene.project, thrown.asset)->material);
    return asset->second->whole.shape->mass.volume * material->density;
}

/// The speed at which a central impact breaks a body, m/s; 0 if it does not break.
double breakingSpeed(const Session& session, const PlayBody& body, double mass) {
    const double threshold = session.thresholdOf(body);
    if (!std::isfinite(threshold) || mass <= 0.0) return 0.0;
    return threshold * (1.0 / mass + movingMass(session.world(), body.body).inverseMass);
}

}  // namespace

std::optional<CastHit> firstHit(const World& world, const Ray& ray) {
    return world.castRay(ray.from, ray.at(kMaxDistance));
}

double reachingSpeed(const Session& session, const Throw& thrown, const Ray& ray) {
    const std::optional<CastHit> hit = firstHit(session.world(), ray);
    double speed = (hit ? glm::distance(ray.from, hit->point) : kDefaultDistance) / kReachingTime;
    if (hit) {
        const PlayBody& body = *session.body(static_cast<std::uint32_t>(session.world().tag(hit->body)));
        const double mass = projectileMass(session.scene(), thrown);
        speed = std::max(speed, kBreakMargin * breakingSpeed(session, body, mass));
    }
    return std::clamp(speed, kMinReachingSpeed, kMaxReachingSpeed);
}

Throw throwAlong(const Session& session, Throw thrown, const Ray& ray) {
    const std::optional<CastHit> hit = firstHit(session.world(), ray);
    thrown.from = ray.from;
    return aimedAt(thrown, hit ? hit->point : ray.at(kDefaultDistance), session.world().gravity());
}

std::optional<Hammer> hammerAlong(const Session& session, double impulse, const Ray& ray,
                                  std::optional<double> radius) {
    const std::optional<CastHit> hit = firstHit(session.world(), ray);
    if (!hit) return std::nullopt;
    return Hammer{hit->point, impulse * ray.direction, radius};
}

std::optional<Blast> blastAlong(const Session& session, Blast blast, const Ray& ray) {
    const std::optional<CastHit> hit = firstHit(session.world(), ray);
    if (!hit) return std::nullopt;
    const double standOff = kStandOff * blast.radius;
    const std::optional<CastHit> opposite =
        session.world().castRay(hit->point, hit->point + 2.0 * standOff * hit->normal);
    blast.at = hit->point + (opposite ? opposite->fraction : 1.0) * standOff * hit->normal;
    return blast;
}

/// The trajectory time t to displacement d at speed v under gravity g solves g²/4 t⁴ - (d·g + v²) t² + d² = 0.
/// The smaller root t² is computed without cancellation, which also covers g = 0.
Throw aimedAt(Throw thrown, Vec3 target, Vec3 gravity) {
    thrown.to = target;
    const Vec3 d = target - thrown.from;
    const double half = glm::dot(d, gravity) + thrown.speed * thrown.speed;
    const double discriminant = half * half - glm::dot(gravity, gravity) * glm::dot(d, d);
    if (half <= 0.0 || discriminant < 0.0) return thrown;
    const double squaredTime = 2.0 * glm::dot(d, d) / (half + std::sqrt(discriminant));
    thrown.to = target - 0.5 * squaredTime * gravity;
    return thrown;
}

Trajectory trajectoryOf(const Session& session, const Throw& thrown, double seconds) {
    const Vec3 aim = thrown.to - thrown.from, gravity = session.world().gravity();
    const double length = std::sqrt(glm::dot(aim, aim));
    Trajectory trajectory{.points = {thrown.from}};
    if (!(length > 0.0)) return trajectory;
    const Vec3 velocity = (thrown.speed / length) * aim;
    const std::uint64_t steps = stepOf(seconds, session.stepLength());
    for (std::uint64_t step = 1; step <= steps && !trajectory.hit; ++step) {
        const double time = static_cast<double>(step) * session.stepLength();
        const Vec3 next = thrown.from + time * velocity + 0.5 * time * time * gravity;
        trajectory.hit = session.world().castRay(trajectory.points.back(), next);
        trajectory.points.push_back(trajectory.hit ? trajectory.hit->point : next);
    }
    return trajectory;
}

}  // namespace rubble
