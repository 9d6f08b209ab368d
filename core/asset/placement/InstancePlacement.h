#pragma once

#include "core/asset/bake/PrismHulls.h"
#include "core/geometry/hull/Ray.h"
#include "core/geometry/search/Box3.h"

#include <optional>
#include <span>

namespace rubble {

/// The depth up to which overlaps of instances count as touching, m: far above rounding, and invisible when play pushes
/// them apart.
inline constexpr double kTouchTolerance = 1e-4;

/// The first hit of a ray in a scene.
struct SceneHit {
    Id instance = 0;  // 0: the ground
    Vec3 point{0.0, 0.0, 0.0};
    Vec3 normal{0.0, 1.0, 0.0};
};

/// The first visible instance that a ray hits, by its exact hulls, or the ground from above; nothing if it hits
/// neither. Instances in `except` are ignored.
std::optional<SceneHit> sceneHit(const Project& project, const AssetHulls& hulls, const Ray& ray,
                                 std::span<const Id> except = {});

/// The position of an instance resting on the hit face in the given orientation: its centre above the point, the whole
/// instance on the outer side of the face.
Vec3 restingPosition(const std::vector<Polytope>& hulls, const Quat& orientation, const SceneHit& hit);

/// The bounding box of instances in the world, m; empty if there are none.
Box3 boundsOf(const Project& project, std::span<const Id> instances);

/// Moves the instances that `before` does not have together along x until they stand beside all others, if their
/// bounding boxes overlap.
void moveAddedBesideOthers(const Project& before, Project& project);

/// The distance that an instance drops until it rests on the ground or another instance, m. Negative if it must be
/// lifted out of the ground, or out of an instance that it has sunk into by less than half of its height; 0 if nothing
/// is below it.
double dropDistance(const Instance& instance, std::span<const Instance> others, const Ground& ground,
                    const AssetHulls& hulls);

}  // namespace rubble
