#include "core/play/scene/Projectile.h"

#include "core/base/Assert.h"
#include "core/geometry/hull/ConvexHull.h"
#include "core/physics/world/BodyScene.h"

#include <array>
#include <cmath>

namespace rubble {
namespace {

constexpr double kProjectileFriction = 0.6;

/// The vertices of an icosahedron with each face divided into nine, on the unit sphere.
std::vector<Vec3> ballCorners() {
    const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
    std::vector<Vec3> corners;
    for (const double one : {-1.0, 1.0}) {
        for (const double other : {-golden, golden}) {
            corners.insert(corners.end(), {{0.0, one, other}, {one, other, 0.0}, {other, 0.0, one}});
        }
    }
    const std::size_t count = corners.size();
    const auto isEdge = [&](std::size_t a, std::size_t b) {
        const Vec3 edge = corners[a] - corners[b];
        return glm::dot(edge, edge) < 4.5;  // edges are 2 long
    };
    for (std::size_t a = 0; a < count; ++a) {
        for (std::size_t b = a + 1; b < count; ++b) {
            if (!isEdge(a, b)) continue;
            corners.push_back((2.0 * corners[a] + corners[b]) / 3.0);
            corners.push_back((corners[a] + 2.0 * corners[b]) / 3.0);
            for (std::size_t c = b + 1; c < count; ++c) {
                if (isEdge(a, c) && isEdge(b, c)) corners.push_back((corners[a] + corners[b] + corners[c]) / 3.0);
            }
        }
    }
    for (Vec3& corner : corners) corner /= std::sqrt(glm::dot(corner, corner));
    return corners;
}

Polytope ball(double radius) {
    std::vector<Vec3> corners = ballCorners();
    for (Vec3& corner : corners) corner *= radius;
    Result<Polytope> hull = convexHull(corners);
    RUBBLE_ASSERT(hull.hasValue());
    return std::move(*hull);
}

Polytope box(Vec3 size) {
    const Vec3 half = size / 2.0;
    const std::array<Vec2, 4> ring{{{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}}};
    return extruded(ring, -half.z, half.z);
}

/// The orientation with -z along a direction and x horizontal.
Quat lookingAlong(Vec3 direction) {
    const Vec3 back = -direction;
    const Vec3 horizontal(direction.z, 0.0, -direction.x);
    const double size = std::sqrt(glm::dot(horizontal, horizontal));
    const Vec3 right = size > 1e-9 ? -horizontal / size : Vec3(1.0, 0.0, 0.0);
    return glm::normalize(glm::quat_cast(Mat3(right, glm::cross(back, right), back)));
}

}  // namespace

Polytope projectileHull(const Throw& thrown) {
    return thrown.kind == ProjectileKind::Ball ? ball(thrown.size.x / 2.0) : box(thrown.size);
}

Result<BodyDefinition> projectileBody(const Throw& thrown, const std::shared_ptr<const Shape>& asset,
                                      const Material* material) {
    const Vec3 path = thrown.to - thrown.from;
    const Vec3 direction = path / std::sqrt(glm::dot(path, path));
    BodyDefinition body{
        .shape = asset, .velocity = thrown.speed * direction, .friction = kProjectileFriction, .isBullet = true};
    body.pose.orientation = lookingAlong(direction);
    if (asset != nullptr) {
        RUBBLE_ASSERT(material != nullptr);
        body.density = material->density;
        body.friction = material->friction;
        body.restitution = material->restitution;
    } else {
        const Polytope hull = projectileHull(thrown);
        Result<std::shared_ptr<const Shape>> shape = makeShape({&hull, 1});
        if (!shape) return shape.error();
        body.shape = std::move(*shape);
        body.density = thrown.mass / body.shape->mass.volume;
    }
    const double mass = body.density * body.shape->mass.volume;
    if (!(mass >= kMinBodyMass && mass <= kMaxBodyMass)) {
        return Error{ErrorCode::BadInput, "The projectile is too light or too heavy to be simulated."};
    }
    body.pose.position = thrown.from - body.pose.orientation * body.shape->mass.centre;
    return body;
}

}  // namespace rubble
