#include "core/play/session/StandingParts.h"

#include "core/base/DisjointSets.h"
#include "core/geometry/hull/Diameter.h"
#include "core/structure/bonds/FragmentSilhouette.h"

#include <algorithm>
#include <map>

namespace rubble {
namespace {

/// The corners of a fragment seen along z.
void addCorners(const Fragment& fragment, std::vector<Vec2>& corners) {
    const Vec3 offset = fragment.offset();
    for (const Vec2& point : silhouetteOf(fragment).outer) corners.push_back(point + Vec2(offset));
}

/// The solid of a body that is not several fragments, and those that it consists of as long as it is whole.
void addSolid(const PlayBody& body, StandingParts& parts) {
    parts.volume += body.asset->solid(body.fragment).shape->mass.volume;
    if (body.fragment != kNone) parts.fragments.push_back(body.fragment);
    if (const PlayFracture* fracture = body.asset->fractureOf(body.fragment)) {
        for (std::uint32_t k = 0; k < fracture->count; ++k) parts.fragments.push_back(fracture->first + k);
    }
}

}  // namespace

StandingParts standingParts(const Session& session, Id instance) {
    StandingParts parts;
    const Pose placed = poseOf(*findInstance(session.scene().project, instance));
    for (const PlayBody& body : session.bodies()) {
        if (body.asset == nullptr || session.origins()[body.origin].instance != instance) continue;
        const Pose pose = session.world().state(body.body).pose;
        const auto stands = [&](std::uint32_t fragment) {
            const Vec3 centre = centreInAsset(body.asset->solid(fragment));
            const Vec3 now = pose.position + pose.orientation * (centre - frameOf(body));
            return glm::distance(now, placed.position + placed.orientation * centre) <= kStandingDistance;
        };
        const std::vector<std::uint32_t> fragments = fragmentsOf(body);
        for (const std::uint32_t fragment : fragments) {
            if (!stands(fragment)) continue;
            parts.volume += body.asset->fragments[fragment].shape->mass.volume;
            parts.fragments.push_back(fragment);
        }
        if (fragments.empty() && stands(body.fragment)) addSolid(body, parts);
    }
    std::ranges::sort(parts.fragments);
    return parts;
}

double holeWidth(const PlayStructure& structure, std::span<const std::uint32_t> standing) {
    const auto isLost = [&](std::uint32_t node) {
        return !std::ranges::binary_search(standing, structure.fragmentOf(node));
    };
    DisjointSets sets(structure.nodeCount());
    for (const Bond& bond : structure.graph.bonds) {
        if (bond.second != kNone && isLost(bond.first) && isLost(bond.second)) sets.merge(bond.first, bond.second);
    }
    std::map<std::uint32_t, std::vector<Vec2>> corners;  // of the sets, by root
    for (std::uint32_t node = 0; node < structure.nodeCount(); ++node) {
        if (isLost(node))
            addCorners(structure.asset->bake->fragment(structure.fragmentOf(node)).solid, corners[sets.rootOf(node)]);
    }
    double width = 0.0;
    for (const auto& [root, points] : corners) width = std::max(width, diameterOf(points));
    return width;
}

}  // namespace rubble
