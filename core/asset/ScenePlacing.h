#pragma once

#include "core/asset/PrismHulls.h"
#include "core/geometry/Ray.h"

#include <optional>
#include <span>

namespace rubble {

/// Overlaps of placed solids up to this are touches, m: rounding is far below, and what it pushes nobody sees.
inline constexpr double kTouchTolerance = 1e-4;

/// What a ray meets in a scene.
struct SceneHit {
    Id instance = 0;  // 0: the ground
    Vec3 point{0.0, 0.0, 0.0};
    Vec3 normal{0.0, 1.0, 0.0};
};

/// What a ray meets first: an instance that is not hidden, or the ground from above; nothing where it meets neither.
/// Instances are held against their exact hulls. `except`: instances that it passes through.
std::optional<SceneHit> sceneHit(const Project& project, const AssetHulls& hulls, const Ray& ray,
                                 std::span<const Id> except = {});

/// Where an instance of an asset rests on what was hit, as it is turned: its middle over the point, and all of it on the
/// outer side of the face.
Vec3 restingPosition(const std::vector<Polytope>& hulls, const Quat& orientation, const SceneHit& hit);

/// How far an instance can fall until it rests on the ground or on one of the others, m. Negative where it has to be lifted:
/// out of the ground, or out of what it has sunk into by less than half of its height. 0 where nothing is below it.
double fallOf(const Instance& instance, std::span<const Instance> others, const Ground& ground,
              const AssetHulls& hulls);

}  // namespace rubble
