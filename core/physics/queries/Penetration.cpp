#include "core/physics/queries/Penetration.h"

#include "core/geometry/hull/HullOverlap.h"
#include "core/geometry/search/BoxTree.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

/// A hull of one of several bodies.
struct BodyHull {
    std::uint32_t body = 0;
    std::uint32_t hull = 0;
};

Box3 boxOf(const PosedHulls& body, const Polytope& hull) {
    const Mat3 rotation = glm::mat3_cast(body.pose.orientation);
    Box3 box;
    for (const Vec3& vertex : hull.vertices) box.include(rotation * vertex + body.pose.position);
    return box;
}

/// Every two hulls that overlap, by their bodies.
std::vector<BodyOverlap> hullDepths(std::span<const PosedHulls> bodies, OverlapSearch& search) {
    std::vector<BodyHull> hulls;
    std::vector<Box3> boxes;
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        for (std::uint32_t hull = 0; hull < bodies[body].hulls.size(); ++hull) {
            hulls.push_back({body, hull});
            boxes.push_back(boxOf(bodies[body], bodies[body].hulls[hull]));
        }
    }
    const BoxTree tree(boxes);
    std::vector<BodyOverlap> depths;
    const auto compare = [&](const BodyHull& a, const BodyHull& b) {
        const PosedHulls &first = bodies[a.body], &second = bodies[b.body];
        const double depth = hullOverlap(first.hulls[a.hull], first.pose, second.hulls[b.hull], second.pose).depth;
        if (depth > search.least) depths.push_back({a.body, b.body, depth});
    };
    for (std::uint32_t i = 0; i < hulls.size() && search.isComplete; ++i) {
        tree.visitOverlapping(boxes[i], [&](std::uint32_t k) {
            const bool isPair =
                hulls[i].body < hulls[k].body && (bodies[hulls[i].body].isDynamic || bodies[hulls[k].body].isDynamic);
            if (!isPair || !search.isComplete) return;
            ++search.compared;
            compare(hulls[i], hulls[k]);
            search.isComplete = depths.size() <= search.most;
        });
    }
    return depths;
}

}  // namespace

std::vector<BodyOverlap> overlapsOf(std::span<const PosedHulls> bodies) {
    OverlapSearch all;
    return overlapsOf(bodies, all);
}

std::vector<BodyOverlap> overlapsOf(std::span<const PosedHulls> bodies, OverlapSearch& search) {
    std::vector<BodyOverlap> depths = hullDepths(bodies, search);
    // The deepest of each pair of bodies first.
    std::sort(depths.begin(), depths.end(), [](const BodyOverlap& a, const BodyOverlap& b) {
        return std::tuple(a.first, a.second, -a.depth) < std::tuple(b.first, b.second, -b.depth);
    });
    const auto isSamePair = [](const BodyOverlap& a, const BodyOverlap& b) {
        return a.first == b.first && a.second == b.second;
    };
    depths.erase(std::unique(depths.begin(), depths.end(), isSamePair), depths.end());
    return depths;
}

Penetration penetrationOf(std::span<const PosedHulls> bodies) {
    Penetration result;
    double sum = 0.0;
    for (const BodyOverlap& overlap : overlapsOf(bodies)) {
        ++result.pairs;
        sum += overlap.depth;
        result.largest = std::max(result.largest, overlap.depth);
    }
    if (result.pairs > 0) result.mean = sum / static_cast<double>(result.pairs);
    return result;
}

}  // namespace rubble
