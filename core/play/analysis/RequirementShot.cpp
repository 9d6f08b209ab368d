#include "core/play/analysis/RequirementShot.h"

#include "core/asset/bake/PrismHulls.h"
#include "core/base/Assert.h"
#include "core/play/analysis/RequirementImpulse.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kFlightTime = 0.04;       // s: long enough to be seen
constexpr double kMaxGravityShare = 0.01;  // of the speed, that gravity may add on the way
constexpr double kClearance = 1.0;         // m, of a falling asset from everything else
constexpr double kDropSpeed = 1e-4;        // m/s, horizontal: a throw has a direction, which keeps the orientation

/// Head-on hits arrive with their own speed: gravity is made up for along the way, and its direction does not change,
/// so that the front of the cube stays parallel to what it hits.
Throw thrownAt(const Throw& touching, const Pose& pose, Vec3 gravity) {
    Throw thrown = touching;
    const Vec3 contact = pose.position + pose.orientation * touching.from;
    const Vec3 path = pose.orientation * (touching.to - touching.from);
    const Vec3 direction = path / std::sqrt(glm::dot(path, path));
    const double pull = std::sqrt(glm::dot(gravity, gravity));
    const double time = pull > 0.0 ? std::min(kFlightTime, kMaxGravityShare * touching.speed / pull) : kFlightTime;
    thrown.speed = touching.speed - time * glm::dot(gravity, direction);
    thrown.from = contact - time * thrown.speed * direction - 0.5 * time * time * gravity;
    thrown.to = thrown.from + direction;
    return thrown;
}

/// The largest x of all instances, m; 0 without any.
double rightEnd(const Project& project) {
    const AssetHulls hulls = assetHulls(project);
    double right = 0.0;
    for (const Instance& instance : project.instances) {
        const auto own = hulls.find(instance.asset);
        if (own == hulls.end()) continue;
        for (const Polytope& hull : own->second) {
            for (const Vec3& vertex : hull.vertices) {
                right = std::max(right, (instance.pose.position + instance.pose.orientation * vertex).x);
            }
        }
    }
    return right;
}

Result<ShotAction> shotOf(const Project& project, const PlayAsset& asset, const DropRequirement& drop,
                          const Instance*) {
    const Vec3 gravity = project.gravity;
    if (!project.ground.isOn) return Error{ErrorCode::BadInput, "A drop needs the ground, which is off."};
    if (gravity.x != 0.0 || gravity.z != 0.0 || !(gravity.y < 0.0)) {
        return Error{ErrorCode::BadInput, "A drop needs gravity that points straight down, along -y."};
    }
    const Shape& shape = *asset.whole.shape;
    const double x = rightEnd(project) + kClearance + shape.boundingRadius;
    const double y = project.ground.height + drop.height + supportAlong(shape, {0.0, -1.0, 0.0}) + shape.mass.centre.y;
    Throw fall{.kind = ProjectileKind::Asset, .asset = asset.bake->asset, .from = {x, y, 0.0}, .speed = kDropSpeed};
    fall.to = fall.from - Vec3(0.0, 0.0, 1.0);
    return ShotAction{fall};
}

Result<ShotAction> shotOf(const Project& project, const PlayAsset& asset, const HitRequirement& hit,
                          const Instance* instance) {
    RUBBLE_ASSERT(instance != nullptr);
    return ShotAction{thrownAt(hitThrow(project, asset, hit), instance->pose, project.gravity)};
}

Result<ShotAction> shotOf(const Project& project, const PlayAsset& asset, const ImpulseRequirement& impact,
                          const Instance* instance) {
    RUBBLE_ASSERT(instance != nullptr);
    const Throw touching = hitThrow(project, asset, {});
    const Quat& orientation = instance->pose.orientation;
    const Vec3 inward = orientation * glm::normalize(touching.to - touching.from);
    const Vec3 front = touching.from + 0.5 * touching.size.x * glm::normalize(touching.to - touching.from);
    return ShotAction{Hammer{instance->pose.position + orientation * front, impact.impulse * inward, std::nullopt}};
}

}  // namespace

const Instance* instanceToTry(const Project& project, const Asset& asset, const StrengthRequirement& requirement,
                              Id preferred) {
    const bool isFixed = supportOf(project, asset, requirement) == AssetSupport::Fixed;
    const auto rank = [&](const Instance& one) {
        const bool isHeldSo =
            isHeldInPlace(project, asset, one) == isFixed || !std::holds_alternative<HitRequirement>(requirement.event);
        return (isHeldSo ? 4 : 0) + (one.threshold ? 0 : 2) + (one.id == preferred ? 1 : 0);
    };
    const Instance* best = nullptr;
    for (const Instance& instance : project.instances) {
        if (instance.asset != asset.id || instance.isUnbreakable) continue;
        if (best == nullptr || rank(instance) > rank(*best)) best = &instance;
    }
    return best;
}

Result<ShotAction> requirementShot(const Project& project, const PlayAsset& asset,
                                   const StrengthRequirement& requirement, const Instance* instance) {
    return std::visit([&](const auto& event) { return shotOf(project, asset, event, instance); }, requirement.event);
}

}  // namespace rubble
