#include "core/play/analysis/Forecast.h"

#include "core/asset/checks/PlayFaults.h"
#include "core/physics/solver/SpeedThresholds.h"
#include "core/play/scene/Projectile.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

Result<ForecastProjectile> forecastProjectile(const Session& session, const Throw& thrown) {
    const PlayScene& scene = session.scene();
    if (std::optional<std::string> fault = faultOf(Shot{.name = "throw", .action = thrown})) {
        return Error{ErrorCode::BadInput, *fault};
    }
    std::shared_ptr<const Shape> shape;
    const Material* material = nullptr;
    if (thrown.kind == ProjectileKind::Asset) {
        const auto asset = scene.assets.find({thrown.asset});
        if (asset == scene.assets.end()) {
            return Error{ErrorCode::BadInput,
                         "Asset " + std::to_string(thrown.asset) + " of the projectile does not exist."};
        }
        shape = asset->second->whole.shape;
        material = findMaterial(scene.project, findAsset(scene.project, thrown.asset)->material);
    }
    const Result<BodyDefinition> body = projectileBody(thrown, shape, material);
    if (!body) return body.error();
    return ForecastProjectile{.mass = body->density * body->shape->mass.volume,
                              .restitution = body->restitution,
                              .from = thrown.from,
                              .speed = thrown.speed,
                              .gravity = scene.project.gravity};
}

/// Also true on the surface, up to rounding.
bool isWithin(const Polytope& hull, Vec3 point) {
    constexpr double kRounding = 1e-9;  // m
    const auto isBehind = [&](const Plane& plane) { return glm::dot(plane.normal, point) <= plane.offset + kRounding; };
    return std::ranges::all_of(hull.planes, isBehind);
}

/// Visits sample points on a body's surface with their normals, in its frame: vertices, midpoints of edges and faces,
/// and the point of each face nearest to the centre of mass. Faces covered by another hull are skipped.
template <class Visit>
void visitSurface(const std::vector<Polytope>& hulls, Vec3 centre, const Visit& visit) {
    constexpr double kOutside = 1e-6;  // m: offset that reaches into a touching hull
    constexpr double kInwards = 1e-4;  // fraction of the way to a face's middle, to stay off its edges
    const auto visitFree = [&](Vec3 point, Vec3 normal, Vec3 middle) {
        const Vec3 beyond = point + kInwards * (middle - point) + kOutside * normal;
        const auto covers = [&](const Polytope& hull) { return isWithin(hull, beyond); };
        if (std::ranges::none_of(hulls, covers)) visit(point, normal);
    };
    for (const Polytope& hull : hulls) {
        for (std::size_t face = 0; face < hull.faces.size(); ++face) {
            const Plane& plane = hull.planes[face];
            const std::vector<std::uint32_t>& loop = hull.faces[face];
            Vec3 middle(0.0);
            for (const std::uint32_t corner : loop) middle += hull.vertices[corner] / static_cast<double>(loop.size());
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec3 corner = hull.vertices[loop[k]], next = hull.vertices[loop[(k + 1) % loop.size()]];
                visitFree(corner, plane.normal, middle);
                visitFree((corner + next) / 2.0, plane.normal, middle);
            }
            visitFree(middle, plane.normal, middle);
            const Vec3 nearest = centre + (plane.offset - glm::dot(plane.normal, centre)) * plane.normal;
            if (isWithin(hull, nearest - kOutside * plane.normal)) visitFree(nearest, plane.normal, middle);
        }
    }
}

void findWeakest(const Session& session, const PlayBody& body, BodyForecast& forecast) {
    if (!std::isfinite(forecast.threshold)) return;
    const Pose pose = session.world().state(body.body).pose;
    const Vec3 centre = glm::conjugate(pose.orientation) * (forecast.mass.centre - pose.position);
    visitSurface(hullsOf(body), centre, [&](Vec3 point, Vec3 normal) {
        const Vec3 position = pose.position + pose.orientation * point;
        const double ratio = forecast.at(position, pose.orientation * normal);
        if (ratio <= forecast.largest) return;
        forecast.largest = ratio;
        forecast.weakest = position;
    });
}

}  // namespace

double BodyForecast::ownMomentum() const {
    if (mass.inverseMass <= 0.0) return 0.0;
    return std::sqrt(glm::dot(mass.velocity, mass.velocity)) * (1.0 - restitution) / mass.inverseMass;
}

double BodyForecast::at(Vec3 point, Vec3 normal) const {
    const Vec3 path = point - projectile.from;
    const double length = std::sqrt(glm::dot(path, path));
    const double squared = projectile.speed * projectile.speed + 2.0 * glm::dot(projectile.gravity, path);
    if (length == 0.0 || squared <= 0.0) return 0.0;
    const double speed = std::sqrt(squared);
    const double approach = glm::dot(mass.velocityAt(point) - path * (speed / length), normal);
    if (approach <= kMinImpactSpeed) return 0.0;
    if (rule == DamageRule::Momentum) return std::max(ownMomentum(), projectile.mass * speed) / threshold;
    const double pair = approach > kMinRestitutionSpeed ? std::max(restitution, projectile.restitution) : 0.0;
    return (1.0 + pair) * approach / (1.0 / projectile.mass + mass.inverseEffectiveMass(point, normal)) / threshold;
}

Result<std::vector<BodyForecast>> breakForecast(const Session& session, const Throw& thrown) {
    const Result<ForecastProjectile> projectile = forecastProjectile(session, thrown);
    if (!projectile) return projectile.error();
    std::vector<BodyForecast> forecasts;
    for (const PlayBody& body : session.bodies()) {
        forecasts.push_back({.body = body.number,
                             .threshold = session.thresholdOf(body),
                             .restitution = session.world().restitution(body.body),
                             .mass = movingMass(session.world(), body.body),
                             .projectile = *projectile,
                             .rule = session.scene().project.damage.rule});
        findWeakest(session, body, forecasts.back());
    }
    return forecasts;
}

}  // namespace rubble
