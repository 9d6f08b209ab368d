#include "core/asset/placement/InstancePlacement.h"

#include "core/asset/project/Ids.h"
#include "core/geometry/hull/HullOverlap.h"
#include "core/geometry/hull/PolytopeRay.h"

#include <algorithm>
#include <limits>
#include <map>

namespace rubble {
namespace {

constexpr double kGapBetweenImports = 0.25;  // m

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Vec3 kDown{0.0, -1.0, 0.0};

const std::vector<Polytope>& hullsOf(const AssetHulls& hulls, Id asset) {
    static const std::vector<Polytope> none;
    const auto found = hulls.find(asset);
    return found != hulls.end() ? found->second : none;
}

/// The extent of points along a direction.
struct Extent {
    double low = kInfinity;
    double high = -kInfinity;
};

Extent extentOf(const std::vector<Polytope>& hulls, const Quat& orientation, Vec3 direction) {
    Extent extent;
    const Vec3 local = glm::conjugate(orientation) * direction;
    for (const Polytope& hull : hulls) {
        for (const Vec3& vertex : hull.vertices) {
            extent.low = std::min(extent.low, glm::dot(vertex, local));
            extent.high = std::max(extent.high, glm::dot(vertex, local));
        }
    }
    return extent;
}

Vec3 middleOf(const std::vector<Polytope>& hulls) {
    Vec3 low(kInfinity), high(-kInfinity);
    for (const Polytope& hull : hulls) {
        for (const Vec3& vertex : hull.vertices) {
            low = glm::min(low, vertex);
            high = glm::max(high, vertex);
        }
    }
    return 0.5 * (low + high);
}

/// A hit and its distance along the ray.
struct Candidate {
    double distance = kInfinity;
    SceneHit hit;
};

void hitGround(const Ground& ground, const Ray& ray, Candidate& nearest) {
    if (!ground.isOn || ray.direction.y >= 0.0 || ray.from.y < ground.height) return;
    const double distance = (ground.height - ray.from.y) / ray.direction.y;
    Vec3 point = ray.at(distance);
    point.y = ground.height;
    nearest = {distance, {.point = point}};
}

void hitInstance(const Instance& instance, const std::vector<Polytope>& hulls, const Ray& ray, Candidate& nearest) {
    const Quat back = glm::conjugate(instance.pose.orientation);
    const Ray local{back * (ray.from - instance.pose.position), back * ray.direction};
    for (const Polytope& hull : hulls) {
        const std::optional<PolytopeRayHit> entry = castRay(hull, local);
        if (!entry || entry->distance >= nearest.distance) continue;
        nearest = {entry->distance, {instance.id, ray.at(entry->distance), instance.pose.orientation * entry->normal}};
    }
}

/// Of the hulls of an asset that is not a mesh; none if it cannot be fractured.
std::vector<Vec3> cornersOfPrism(const Asset& asset) {
    std::vector<Vec3> corners;
    const Result<Prism> prism = validated(asset.prism());
    if (!prism) return corners;
    const Result<std::vector<Polytope>> hulls = prismHulls(*prism);
    if (!hulls) return corners;
    for (const Polytope& hull : *hulls) corners.insert(corners.end(), hull.vertices.begin(), hull.vertices.end());
    return corners;
}

/// The drop of `upper` onto `lower`; infinite if it misses it or has sunk deeper than `maxDepth`.
double dropOnto(const Instance& upper, const Instance& lower, const AssetHulls& hulls, double maxDepth) {
    double drop = kInfinity;
    for (const Polytope& first : hullsOf(hulls, upper.asset)) {
        for (const Polytope& second : hullsOf(hulls, lower.asset)) {
            const auto distance = distanceAlong(kDown, first, upper.pose, second, lower.pose, kTouchTolerance);
            if (distance && *distance >= -maxDepth) drop = std::min(drop, *distance);
        }
    }
    return drop;
}

}  // namespace

std::optional<SceneHit> sceneHit(const Project& project, const AssetHulls& hulls, const Ray& ray,
                                 std::span<const Id> except) {
    Candidate nearest;
    hitGround(project.ground, ray, nearest);
    for (const Instance& instance : project.instances) {
        if (instance.isHidden || isAmong(except, instance.id)) continue;
        hitInstance(instance, hullsOf(hulls, instance.asset), ray, nearest);
    }
    if (nearest.distance == kInfinity) return std::nullopt;
    return nearest.hit;
}

Vec3 restingPosition(const std::vector<Polytope>& hulls, const Quat& orientation, const SceneHit& hit) {
    if (hulls.empty()) return hit.point;
    const Vec3 middle = orientation * middleOf(hulls);
    const double beneath = glm::dot(middle, hit.normal) - extentOf(hulls, orientation, hit.normal).low;
    return hit.point - middle + beneath * hit.normal;
}

double dropDistance(const Instance& instance, std::span<const Instance> others, const Ground& ground,
                    const AssetHulls& hulls) {
    const std::vector<Polytope>& own = hullsOf(hulls, instance.asset);
    if (own.empty()) return 0.0;
    const Extent height = extentOf(own, instance.pose.orientation, -kDown);
    double drop = kInfinity;
    if (ground.isOn) drop = instance.pose.position.y + height.low - ground.height;
    for (const Instance& other : others) {
        if (other.id != instance.id)
            drop = std::min(drop, dropOnto(instance, other, hulls, (height.high - height.low) / 2.0));
    }
    return drop == kInfinity ? 0.0 : drop;
}

Box3 boundsOf(const Project& project, std::span<const Id> instances) {
    std::map<Id, std::vector<Vec3>> cornersOf;  // of prisms
    Box3 box;
    for (const Instance& instance : project.instances) {
        const Asset* asset = isAmong(instances, instance.id) ? findById(project.assets, instance.asset) : nullptr;
        if (!asset) continue;
        std::span<const Vec3> corners;
        if (const ClosedMesh* mesh = asset->mesh()) {
            corners = mesh->mesh.points;
        } else {
            const auto [found, isNew] = cornersOf.try_emplace(asset->id);
            if (isNew) found->second = cornersOfPrism(*asset);
            corners = found->second;
        }
        for (const Vec3& corner : corners) box.include(instance.pose.position + instance.pose.orientation * corner);
    }
    return box;
}

void moveAddedBesideOthers(const Project& before, Project& project) {
    std::vector<Id> added, others;
    for (const Instance& instance : project.instances) {
        (findById(before.instances, instance.id) ? others : added).push_back(instance.id);
    }
    const Box3 moved = boundsOf(project, added), kept = boundsOf(project, others);
    if (moved.isEmpty() || kept.isEmpty()) return;
    const bool isBeside =
        glm::any(glm::lessThanEqual(moved.max, kept.min)) || glm::any(glm::lessThanEqual(kept.max, moved.min));
    if (isBeside) return;
    for (Instance& instance : project.instances) {
        if (!findById(before.instances, instance.id))
            instance.pose.position.x += kept.max.x + kGapBetweenImports - moved.min.x;
    }
}

}  // namespace rubble
