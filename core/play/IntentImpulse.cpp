#include "core/play/IntentImpulse.h"

#include "core/base/Assert.h"
#include "core/play/Damage.h"
#include "core/play/Missile.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMoment = 1e-4;     // s, in which those that touch are looked at: no body comes far in it
constexpr double kCubeSide = 0.2;    // m, of what hits
constexpr double kCubeShare = 0.2;   // of the outline's lesser side, at most
constexpr double kGroundMargin = 1;  // m of ground around what falls on it

const Asset& assetOf(const Project& project, const PlayAsset& asset) {
    const Asset* found = findAsset(project, asset.bake->asset);
    RUBBLE_ASSERT(found != nullptr);
    return *found;
}

/// How far a shape reaches along a direction from its frame, m.
double reachAlong(const Shape& shape, Vec3 direction) {
    double reach = -1e308;
    for (const Hull& hull : shape.hulls) {
        const Vec3 corner = toDouble(hull.corner(hull.farthest(toFloat(direction))));
        reach = std::max(reach, glm::dot(corner + shape.mass.centre, direction));
    }
    return reach;
}

Vec2 nearestOnRing(const Ring& ring, Vec2 point, Vec2 nearest) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 start = ring[k], way = ring[(k + 1) % ring.size()] - start;
        const double share = std::clamp(glm::dot(point - start, way) / glm::dot(way, way), 0.0, 1.0);
        const Vec2 candidate = start + share * way;
        if (glm::distance(candidate, point) < glm::distance(nearest, point)) nearest = candidate;
    }
    return nearest;
}

/// Where the line through a point along z meets a prism, or the point of the outline that is nearest to it.
Vec2 placeOfHit(const Polygon& outline, Vec2 point) {
    if (containment(outline, point) != Containment::Outside) return point;
    Vec2 nearest = nearestOnRing(outline.outer, point, outline.outer[0]);
    for (const Ring& hole : outline.holes) nearest = nearestOnRing(hole, point, nearest);
    return nearest;
}

/// The asset as a body in the prism's frame.
BodyDefinition standing(const Project& project, const PlayAsset& asset) {
    const Material& material = *findMaterial(project, assetOf(project, asset).material);
    return {.shape = asset.whole.shape,
            .density = material.density,
            .friction = material.friction,
            .restitution = material.restitution};
}

/// The damage to the first of two bodies that touch.
Result<double> damageAtTouch(const BodyDefinition& first, const BodyDefinition& second, DamageRule rule) {
    World world({.gravity = Vec3(0.0)});
    const Result<BodyId> hit = world.addBody(first);
    if (!hit) return hit.error();
    const Result<BodyId> other = world.addBody(second);
    if (!other) return other.error();
    world.collide(kMoment);
    for (const DamageDone& damage : damageOf(world.impacts(), world, rule)) {
        if (damage.body == *hit) return damage.amount;
    }
    return 0.0;
}

Result<BodyDefinition> groundBelow(const Project& project, const Shape& shape) {
    const double breadth = 2.0 * (shape.reach + kGroundMargin);
    const Polytope box = missileHull({.size = Vec3(breadth)});
    Result<std::shared_ptr<const Shape>> made = makeShape({&box, 1});
    if (!made) return made.error();
    const Vec3 centre = shape.mass.centre;
    return BodyDefinition{
        .shape = std::move(*made),
        .kind = BodyKind::Static,
        .pose = {.position = {centre.x, -reachAlong(shape, {0.0, -1.0, 0.0}) - breadth / 2.0, centre.z}},
        .friction = project.ground.friction,
        .restitution = project.ground.restitution};
}

Result<double> impulseOf(const Project& project, const PlayAsset& asset, const DropIntent& drop) {
    const Vec3 gravity = project.gravity;
    if (gravity.x != 0.0 || gravity.z != 0.0 || !(gravity.y < 0.0)) {
        return Error{ErrorCode::BadInput,
                     "What a drop does can only be told where gravity points straight down, along -y."};
    }
    const Result<BodyDefinition> ground = groundBelow(project, *asset.whole.shape);
    if (!ground) return ground.error();
    BodyDefinition falling = standing(project, asset);
    falling.velocity = {0.0, -std::sqrt(-2.0 * gravity.y * drop.height), 0.0};
    return damageAtTouch(falling, *ground, project.damage.rule);
}

Result<double> impulseOf(const Project& project, const PlayAsset& asset, const HitIntent& hit) {
    const Result<BodyDefinition> cube = missile(hitThrow(project, asset, hit), nullptr, nullptr);
    if (!cube) return cube.error();
    return damageAtTouch(standing(project, asset), *cube, project.damage.rule);
}

}  // namespace

Result<double> intentImpulse(const Project& project, const PlayAsset& asset, const Intent& intent) {
    return std::visit([&](const auto& event) { return impulseOf(project, asset, event); }, intent.event);
}

Throw hitThrow(const Project& project, const PlayAsset& asset, const HitIntent& hit) {
    const Polygon& outline = assetOf(project, asset).prism.outline;
    const Vec2 size = boundsOf(outline.outer).size();
    const double side = std::min(kCubeSide, kCubeShare * std::min(size.x, size.y));
    const Shape& shape = *asset.whole.shape;
    const Vec2 place = placeOfHit(outline, Vec2(shape.mass.centre));
    const double front = reachAlong(shape, {0.0, 0.0, 1.0});
    return {.size = Vec3(side),
            .mass = hit.mass,
            .from = {place, front + side / 2.0},
            .to = {place, front - side / 2.0},
            .speed = hit.speed};
}

}  // namespace rubble
