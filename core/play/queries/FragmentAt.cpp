#include "core/play/queries/FragmentAt.h"

#include "core/physics/queries/HullDistance.h"

#include <algorithm>
#include <limits>

namespace rubble {
namespace {

/// The distance of a point from a solid, both in the asset's frame, m.
double distanceToSolid(const PlaySolid& solid, Vec3 point) {
    const Vec3 local = point - centreInAsset(solid);
    double least = std::numeric_limits<double>::infinity();
    for (const PlacedHull& placed : solid.shape->hulls)
        least = std::min(least, distanceTo(*placed.hull, local - toDouble(placed.offset)));
    return least;
}

}  // namespace

std::optional<std::uint32_t> fragmentAt(const World& world, const PlayBody& body, Vec3 point) {
    const std::vector<std::uint32_t> fragments = bondedFragments(body);
    if (fragments.empty()) return std::nullopt;
    const Pose pose = world.state(body.body).pose;
    const Vec3 local = glm::conjugate(pose.orientation) * (point - pose.position) + frameOf(body);
    return *std::ranges::min_element(
        fragments, {}, [&](std::uint32_t fragment) { return distanceToSolid(body.asset->fragments[fragment], local); });
}

}  // namespace rubble
