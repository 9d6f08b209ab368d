#include "core/play/analysis/RequirementImpulse.h"

#include "core/base/Assert.h"
#include "core/play/breaking/Damage.h"
#include "core/play/breaking/MovingMass.h"
#include "core/play/scene/Projectile.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kCollisionStep = 1e-4;   // s, short enough that bodies hardly move
constexpr double kCubeSide = 0.2;         // m
constexpr double kMaxCubeFraction = 0.2;  // of the outline's shorter side
constexpr double kGroundMargin = 1;       // m of ground around the falling body

const Asset& assetOf(const Project& project, const PlayAsset& asset) {
    const Asset* found = findAsset(project, asset.bake->asset);
    RUBBLE_ASSERT(found != nullptr);
    return *found;
}

Vec2 nearestOnRing(const Ring& ring, Vec2 point, Vec2 nearest) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 start = ring[k], edge = ring[(k + 1) % ring.size()] - start;
        const double t = std::clamp(glm::dot(point - start, edge) / glm::dot(edge, edge), 0.0, 1.0);
        const Vec2 candidate = start + t * edge;
        if (glm::distance(candidate, point) < glm::distance(nearest, point)) nearest = candidate;
    }
    return nearest;
}

/// The point itself if it lies in the outline, else the nearest point of the outline.
Vec2 hitPoint(const Polygon& outline, Vec2 point) {
    if (containment(outline, point) != Containment::Outside) return point;
    Vec2 nearest = nearestOnRing(outline.outer, point, outline.outer[0]);
    for (const Ring& hole : outline.holes) nearest = nearestOnRing(hole, point, nearest);
    return nearest;
}

/// The asset as a body in the prism's frame.
BodyDefinition standing(const Project& project, const PlayAsset& asset, Support support) {
    const Material& material = *findMaterial(project, assetOf(project, asset).material);
    return {.shape = asset.whole.shape,
            .kind = support == Support::Fixed ? BodyKind::Static : BodyKind::Dynamic,
            .density = material.density,
            .friction = material.friction,
            .restitution = material.restitution};
}

/// The damage to the first of two touching bodies.
Result<double> damageAtContact(const BodyDefinition& first, const BodyDefinition& second, DamageRule rule) {
    World world({.gravity = Vec3(0.0)});
    const Result<BodyId> hit = world.addBody(first);
    if (!hit) return hit.error();
    const Result<BodyId> other = world.addBody(second);
    if (!other) return other.error();
    world.collide(kCollisionStep);
    for (const DamageDone& damage : damageOf(world.impacts(), world, rule)) {
        if (damage.body == *hit) return damage.amount;
    }
    return 0.0;
}

Result<BodyDefinition> groundBelow(const Project& project, const Shape& shape) {
    const double width = 2.0 * (shape.boundingRadius + kGroundMargin);
    const Polytope box = projectileHull({.size = Vec3(width)});
    Result<std::shared_ptr<const Shape>> made = makeShape({&box, 1});
    if (!made) return made.error();
    const Vec3 centre = shape.mass.centre;
    return BodyDefinition{
        .shape = std::move(*made),
        .kind = BodyKind::Static,
        .pose = {.position = {centre.x, -supportAlong(shape, {0.0, -1.0, 0.0}) - width / 2.0, centre.z}},
        .friction = project.ground.friction,
        .restitution = project.ground.restitution};
}

Result<double> impulseOf(const Project& project, const PlayAsset& asset, const DropRequirement& drop, Support support) {
    const Vec3 gravity = project.gravity;
    if (gravity.x != 0.0 || gravity.z != 0.0 || !(gravity.y < 0.0)) {
        return Error{ErrorCode::BadInput, "A drop needs gravity that points straight down, along -y."};
    }
    const Result<BodyDefinition> ground = groundBelow(project, *asset.whole.shape);
    if (!ground) return ground.error();
    BodyDefinition falling = standing(project, asset, support);
    falling.velocity = {0.0, -std::sqrt(-2.0 * gravity.y * drop.height), 0.0};
    return damageAtContact(falling, *ground, project.damage.rule);
}

Result<double> impulseOf(const Project& project, const PlayAsset& asset, const HitRequirement& hit, Support support) {
    const Result<BodyDefinition> cube = projectileBody(hitThrow(project, asset, hit), nullptr, nullptr);
    if (!cube) return cube.error();
    return damageAtContact(standing(project, asset, support), *cube, project.damage.rule);
}

Result<double> impulseOf(const Project&, const PlayAsset&, const ImpulseRequirement& impact, Support) {
    return impact.impulse;
}

}  // namespace

Support supportOf(const Project& project, const Asset& asset, const StrengthRequirement& requirement) {
    if (!std::holds_alternative<HitRequirement>(requirement.event)) return Support::Free;
    const auto isBreakable = [&](const Instance& instance) {
        return instance.asset == asset.id && !instance.isUnbreakable;
    };
    const auto fixed = [&](const Instance& instance) { return isBreakable(instance) && instance.isFixed; };
    const auto free = [&](const Instance& instance) { return isBreakable(instance) && !instance.isFixed; };
    if (std::ranges::none_of(project.instances, fixed)) return Support::Free;
    const bool areMixed = std::ranges::any_of(project.instances, free);
    return areMixed && requirement.outcome == RequirementOutcome::Breaks ? Support::Free : Support::Fixed;
}

Result<double> requirementImpulse(const Project& project, const PlayAsset& asset,
                                  const StrengthRequirement& requirement) {
    const Support support = supportOf(project, assetOf(project, asset), requirement);
    return std::visit([&](const auto& event) { return impulseOf(project, asset, event, support); }, requirement.event);
}

double cornerFraction(const Project& project, const PlayAsset& asset, const HitRequirement& hit, Support support) {
    if (support == Support::Fixed || project.damage.rule == DamageRule::Momentum) return 1.0;
    const Asset& authored = assetOf(project, asset);
    const MovingMass struck = restingMass(*asset.whole.shape, findMaterial(project, authored.material)->density, {});
    const Vec2 centre(struck.centre);
    Vec2 farthest = centre;
    for (const Vec2& corner : authored.prism.outline.outer) {
        if (glm::distance(corner, centre) > glm::distance(farthest, centre)) farthest = corner;
    }
    const double atCorner = struck.inverseEffectiveMass({farthest, struck.centre.z}, {0.0, 0.0, 1.0}) + 1.0 / hit.mass;
    return (struck.inverseMass + 1.0 / hit.mass) / atCorner;
}

Throw hitThrow(const Project& project, const PlayAsset& asset, const HitRequirement& hit) {
    const Polygon& outline = assetOf(project, asset).prism.outline;
    const Vec2 size = boundsOf(outline.outer).size();
    const double side = std::min(kCubeSide, kMaxCubeFraction * std::min(size.x, size.y));
    const Shape& shape = *asset.whole.shape;
    const Vec2 point = hitPoint(outline, Vec2(shape.mass.centre));
    const double front = supportAlong(shape, {0.0, 0.0, 1.0});
    return {.size = Vec3(side),
            .mass = hit.mass,
            .from = {point, front + side / 2.0},
            .to = {point, front - side / 2.0},
            .speed = hit.speed};
}

double supportAlong(const Shape& shape, Vec3 direction) {
    double support = -1e308;
    for (const PlacedHull& placed : shape.hulls) {
        const Hull& hull = *placed.hull;
        const Vec3 corner = toDouble(placed.offset + hull.corner(hull.farthest(toFloat(direction))));
        support = std::max(support, glm::dot(corner + shape.mass.centre, direction));
    }
    return support;
}

}  // namespace rubble
