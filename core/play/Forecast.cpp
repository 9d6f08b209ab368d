#include "core/play/Forecast.h"

#include "core/asset/PlayFaults.h"
#include "core/physics/ImpactSpeeds.h"
#include "core/play/Missile.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

Result<ForecastMissile> missileOf(const Session& session, const Throw& thrown) {
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
                         "Asset " + std::to_string(thrown.asset) + ", which is thrown, is not there."};
        }
        shape = asset->second->whole.shape;
        material = findMaterial(scene.project, findAsset(scene.project, thrown.asset)->material);
    }
    const Result<BodyDefinition> body = missile(thrown, shape, material);
    if (!body) return body.error();
    return ForecastMissile{.mass = body->density * body->shape->mass.volume,
                           .restitution = body->restitution,
                           .from = thrown.from,
                           .speed = thrown.speed,
                           .gravity = scene.project.gravity};
}

/// On the surface, too, wherever rounding puts it.
bool isWithin(const Polytope& hull, Vec3 point) {
    constexpr double kRounding = 1e-9;  // m
    const auto isBehind = [&](const Plane& plane) { return glm::dot(plane.normal, point) <= plane.offset + kRounding; };
    return std::ranges::all_of(hull.planes, isBehind);
}

/// Visits points spread over the faces of a body's hulls that lie on its surface, with their normals, in its frame: corners,
/// the middles of edges and faces, and where a face is nearest to the centre of mass.
template <class Visit>
void visitSurface(const std::vector<Polytope>& hulls, Vec3 centre, const Visit& visit) {
    constexpr double kOutside = 1e-6;  // m: there another hull begins where two touch
    constexpr double kInwards = 1e-4;  // of the way to a face's middle: at its very corners other faces begin
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
        const Vec3 place = pose.position + pose.orientation * point;
        const double ratio = forecast.at(place, pose.orientation * normal);
        if (ratio <= forecast.largest) return;
        forecast.largest = ratio;
        forecast.weakest = place;
    });
}

}  // namespace

double BodyForecast::ownMomentum() const {
    if (mass.inverseMass <= 0.0) return 0.0;
    return std::sqrt(glm::dot(mass.velocity, mass.velocity)) * (1.0 - restitution) / mass.inverseMass;
}

double BodyForecast::at(Vec3 point, Vec3 normal) const {
    const Vec3 way = point - missile.from;
    const double length = std::sqrt(glm::dot(way, way));
    const double squared = missile.speed * missile.speed + 2.0 * glm::dot(missile.gravity, way);
    if (length == 0.0 || squared <= 0.0) return 0.0;
    const double speed = std::sqrt(squared);
    const double approach = glm::dot(mass.velocityAt(point) - way * (speed / length), normal);
    if (approach <= kImpactSpeed) return 0.0;
    if (rule == DamageRule::Momentum) return std::max(ownMomentum(), missile.mass * speed) / threshold;
    const double pair = approach > kRestitutionSpeed ? std::max(restitution, missile.restitution) : 0.0;
    return (1.0 + pair) * approach / (1.0 / missile.mass + mass.mobility(point, normal)) / threshold;
}

Result<std::vector<BodyForecast>> breakForecast(const Session& session, const Throw& thrown) {
    const Result<ForecastMissile> missile = missileOf(session, thrown);
    if (!missile) return missile.error();
    std::vector<BodyForecast> forecasts;
    for (const PlayBody& body : session.bodies()) {
        forecasts.push_back({.body = body.number,
                             .threshold = session.thresholdOf(body),
                             .restitution = session.world().restitution(body.body),
                             .mass = movingMass(session.world(), body.body),
                             .missile = *missile,
                             .rule = session.scene().project.damage.rule});
        findWeakest(session, body, forecasts.back());
    }
    return forecasts;
}

}  // namespace rubble
