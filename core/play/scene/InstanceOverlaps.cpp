#include "core/play/scene/InstanceOverlaps.h"

#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/physics/queries/Penetration.h"

#include <algorithm>

namespace rubble {
namespace {

std::string nameOf(const Project& project, Id instance) {
    const Instance* found = findInstance(project, instance);
    return found != nullptr ? quotedName(found->name) : std::to_string(instance);
}

double depthInGround(const PosedHulls& body, const Ground& ground) {
    double lowest = ground.height;
    for (const Polytope& hull : body.hulls) {
        for (const Vec3& vertex : hull.vertices) {
            lowest = std::min(lowest, body.pose.position.y + (body.pose.orientation * vertex).y);
        }
    }
    return ground.height - lowest;
}

}  // namespace

std::vector<InstanceOverlap> instanceOverlaps(const Project& project, bool* isComplete) {
    const AssetHulls hulls = assetHulls(project);
    std::vector<PosedHulls> bodies;
    for (const Instance& instance : project.instances) {
        const auto own = hulls.find(instance.asset);
        bodies.push_back({own != hulls.end() ? own->second : std::span<const Polytope>(), instance.pose});
    }
    std::vector<InstanceOverlap> overlaps;
    for (std::size_t k = 0; k < bodies.size() && project.ground.isOn; ++k) {
        const double depth = depthInGround(bodies[k], project.ground);
        if (depth > kTouchTolerance && !project.instances[k].isFixed) {
            overlaps.push_back({project.instances[k].id, 0, depth});
        }
    }
    OverlapSearch search{.least = kTouchTolerance, .most = kMaxOverlaps};
    for (const auto& [first, second, depth] : overlapsOf(bodies, search))
        overlaps.push_back({project.instances[first].id, project.instances[second].id, depth});
    if (isComplete) *isComplete = search.isComplete;
    std::ranges::sort(overlaps, {}, [](const InstanceOverlap& o) { return std::pair(o.first, o.second); });
    return overlaps;
}

std::string sentenceOf(const InstanceOverlap& overlap, const Project& project) {
    const std::string first = nameOf(project, overlap.first);
    const std::string depth = quantityText(QuantityKind::Length, overlap.depth);
    if (overlap.second == 0) return first + " stands " + depth + " deep in the ground.";
    return first + " and " + nameOf(project, overlap.second) + " overlap by " + depth + ".";
}

std::string otherOverlapsText(std::size_t found, bool isComplete) {
    const std::string number = std::to_string(found - std::min(found, kListedOverlaps));
    return "Instances overlap in " + (isComplete ? number : "more than " + number) + " more places.";
}

std::vector<OverlapNote> overlapNotes(const Project& project) {
    bool isComplete = true;
    const std::vector<InstanceOverlap> overlaps = instanceOverlaps(project, &isComplete);
    std::vector<OverlapNote> notes;
    for (std::size_t k = 0; k < std::min(overlaps.size(), kListedOverlaps); ++k) {
        notes.push_back({sentenceOf(overlaps[k], project), {overlaps[k].first}});
        if (overlaps[k].second != 0) notes.back().instances.push_back(overlaps[k].second);
    }
    if (overlaps.size() > kListedOverlaps) notes.push_back({otherOverlapsText(overlaps.size(), isComplete), {}});
    return notes;
}

}  // namespace rubble
