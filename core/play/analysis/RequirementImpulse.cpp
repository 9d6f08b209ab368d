#include "core/play/analysis/RequirementImpulse.h"

#include "core/asset/project/AssetShape.h"
#include "core/base/Assert.h"
#include "core/geometry/hull/PolytopeRay.h"
#include "core/play/breaking/DamageDone.h"
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

/// The point itself if it lies in the outline, else one a little behind the nearest point of the outline, since what
/// is on the very edge can be missed.
Vec2 hitPoint(const Polygon& outline, Vec2 point) {
    constexpr double kInward = 1e-4;  // of the outline's shorter side
    if (containment(outline, point) != Containment::Outside) return point;
    Vec2 nearest = nearestOnRing(outline.outer, point, outline.outer[0]);
    for (const Ring& hole : outline.holes) nearest = nearestOnRing(hole, point, nearest);
    const Vec2 size = boundsOf(outline.outer).size();
    const Vec2 inward = nearest + kInward * std::min(size.x, size.y) * glm::normalize(nearest - point);
    return containment(outline, inward) == Containment::Inside ? inward : nearest;
}

/// The asset as a body in the prism's frame.
BodyDefinition standing(const Project& project, const PlayAsset& asset, AssetSupport support) {
    const Material& material = *findMaterial(project, assetOf(project, asset).material);
    return {.shape = asset.whole.shape,
            .kind = support == AssetSupport::Fixed ? BodyKind::Static : BodyKind::Dynamic,
            .density = material.density,
            .friction = material.friction,
            .restitution = material.restitution};
}

/// Two touching bodies, of which the first is hit.
struct TouchingBodies {
    BodyDefinition hit;
    BodyDefinition other;
};

/// The damage to the first of two touching bodies.
Result<double> damageAtContact(const TouchingBodies& bodies, DamageRule rule) {
    World world({.gravity = Vec3(0.0)});
    const Result<BodyId> hit = world.addBody(bodies.hit);
    if (!hit) return hit.error();
    const Result<BodyId> other = world.addBody(bodies.other);
    if (!other) return other.error();
    world.collide(kCollisionStep);
    for (const DamageDone& damage : damageOf(world.impacts(), world, rule)) {
        if (damage.body == *hit) return damage.amount;
    }
    return 0.0;
}

/// The impact of two touching bodies, with its points in the frame of the first, which is at the origin or not turned.
Result<RequirementImpact> impactAtContact(const TouchingBodies& bodies) {
    World world({.gravity = Vec3(0.0)});
    for (const BodyDefinition* body : {&bodies.hit, &bodies.other}) {
        if (const Result<BodyId> added = world.addBody(*body); !added) return added.error();
    }
    world.collide(kCollisionStep);
    RequirementImpact all;
    for (const Impact& impact : world.impacts()) {
        all.impulse = std::max(all.impulse, impact.impulse());
        all.points.push_back(impact.point - bodies.hit.pose.position);
    }
    return all;
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

Result<TouchingBodies> touchingBodies(const Project& project, const PlayAsset& asset, const DropRequirement& drop,
                                      AssetSupport support) {
    const Vec3 gravity = project.gravity;
    if (gravity.x != 0.0 || gravity.z != 0.0 || !(gravity.y < 0.0)) {
        return Error{ErrorCode::BadInput, "A drop needs gravity that points straight down, along -y."};
    }
    Result<BodyDefinition> ground = groundBelow(project, *asset.whole.shape);
    if (!ground) return ground.error();
    BodyDefinition falling = standing(project, asset, support);
    falling.velocity = {0.0, -std::sqrt(-2.0 * gravity.y * drop.height), 0.0};
    return TouchingBodies{std::move(falling), std::move(*ground)};
}

Result<TouchingBodies> touchingBodies(const Project& project, const PlayAsset& asset, const HitRequirement& hit,
                                      AssetSupport support) {
    Result<BodyDefinition> cube = projectileBody(hitThrow(project, asset, hit), nullptr, nullptr);
    if (!cube) return cube.error();
    return TouchingBodies{standing(project, asset, support), std::move(*cube)};
}

/// The point of the front of a mesh that hits meet: before its centre of mass, or of its largest hull if it has a hole
/// there.
Vec3 frontOf(const Bake& bake, Vec3 centre) {
    constexpr double kFar = 1e6;  // m: beyond any asset
    const std::vector<Polytope> hulls = wholeHullsInPrism(bake);
    const auto frontAt = [&](Vec2 point) {
        std::optional<Vec3> front;
        for (const Polytope& hull : hulls) {
            const Vec3 from{point, kFar};
            const std::optional<PolytopeRayHit> hit = castRay(hull, {from, {0.0, 0.0, -1.0}});
            if (hit && (!front || kFar - hit->distance > front->z)) front = Vec3{point, kFar - hit->distance};
        }
        return front;
    };
    if (const std::optional<Vec3> front = frontAt(Vec2(centre))) return *front;
    const Polytope* largest = &*std::ranges::max_element(hulls, {}, [](const Polytope& h) { return massOf(h).volume; });
    return *frontAt(Vec2(massOf(*largest).centre));
}

/// The point of the front that hits meet, in the asset's frame.
Vec3 frontPoint(const Project& project, const PlayAsset& asset) {
    const Shape& shape = *asset.whole.shape;
    const Asset& authored = assetOf(project, asset);
    if (!authored.isPrism()) return frontOf(*asset.bake, shape.mass.centre);
    const Vec2 point = hitPoint(authored.prism().outline, Vec2(shape.mass.centre));
    return {point, supportAlong(shape, {0.0, 0.0, 1.0})};
}

/// The bodies of a drop or a hit.
Result<TouchingBodies> bodiesOf(const Project& project, const PlayAsset& asset,
                                const StrengthRequirement& requirement) {
    const AssetSupport support = supportOf(project, assetOf(project, asset), requirement);
    if (const auto* drop = std::get_if<DropRequirement>(&requirement.event))
        return touchingBodies(project, asset, *drop, support);
    return touchingBodies(project, asset, std::get<HitRequirement>(requirement.event), support);
}

}  // namespace

AssetSupport supportOf(const Project& project, const Asset& asset, const StrengthRequirement& requirement) {
    if (!std::holds_alternative<HitRequirement>(requirement.event)) return AssetSupport::Free;
    const auto isBreakable = [&](const Instance& instance) {
        return instance.asset == asset.id && !instance.isUnbreakable;
    };
    const auto isHeld = [&](const Instance& instance) { return isHeldInPlace(project, asset, instance); };
    const auto held = [&](const Instance& instance) { return isBreakable(instance) && isHeld(instance); };
    const auto free = [&](const Instance& instance) { return isBreakable(instance) && !isHeld(instance); };
    if (std::ranges::none_of(project.instances, held)) return AssetSupport::Free;
    const bool areMixed = std::ranges::any_of(project.instances, free);
    return areMixed && requirement.outcome == RequirementOutcome::Breaks ? AssetSupport::Free : AssetSupport::Fixed;
}

Result<double> requirementImpulse(const Project& project, const PlayAsset& asset,
                                  const StrengthRequirement& requirement) {
    if (const auto* impact = std::get_if<ImpulseRequirement>(&requirement.event)) return impact->impulse;
    const Result<TouchingBodies> bodies = bodiesOf(project, asset, requirement);
    return bodies ? damageAtContact(*bodies, project.damage.rule) : bodies.error();
}

Result<RequirementImpact> requirementImpact(const Project& project, const PlayAsset& asset,
                                            const StrengthRequirement& requirement) {
    if (const auto* impact = std::get_if<ImpulseRequirement>(&requirement.event))
        return RequirementImpact{impact->impulse, {frontPoint(project, asset)}};
    const Result<TouchingBodies> bodies = bodiesOf(project, asset, requirement);
    return bodies ? impactAtContact(*bodies) : bodies.error();
}

double cornerFraction(const Project& project, const PlayAsset& asset, const HitRequirement& hit, AssetSupport support) {
    if (support == AssetSupport::Fixed || project.damage.rule == DamageRule::Momentum) return 1.0;
    const Asset& authored = assetOf(project, asset);
    const MovingMass struck = restingMass(*asset.whole.shape, findMaterial(project, authored.material)->density, {});
    const Vec2 centre(struck.centre);
    Vec2 farthest = centre;
    const Box2 box = planeBoundsOf(authored);
    const Ring corners = authored.isPrism() ? authored.prism().outline.outer
                                            : Ring{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    for (const Vec2& corner : corners) {
        if (glm::distance(corner, centre) > glm::distance(farthest, centre)) farthest = corner;
    }
    const double atCorner = struck.inverseEffectiveMass({farthest, struck.centre.z}, {0.0, 0.0, 1.0}) + 1.0 / hit.mass;
    return (struck.inverseMass + 1.0 / hit.mass) / atCorner;
}

Throw hitThrow(const Project& project, const PlayAsset& asset, const HitRequirement& hit) {
    const Vec2 size = planeBoundsOf(assetOf(project, asset)).size();
    const double side = std::min(kCubeSide, kMaxCubeFraction * std::min(size.x, size.y));
    const Vec3 point = frontPoint(project, asset);
    const Vec3 half(0.0, 0.0, side / 2.0);
    return {.size = Vec3(side), .mass = hit.mass, .from = point + half, .to = point - half, .speed = hit.speed};
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
