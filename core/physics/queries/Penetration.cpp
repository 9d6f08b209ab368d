#include "core/physics/queries/Penetration.h"

#include "core/base/Assert.h"
#include "core/geometry/hull/HullOverlap.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

/// The bounding box of a hull in world space.
struct HullBox {
    std::uint32_t body = 0;
    std::uint32_t hull = 0;
    Vec3 low;
    Vec3 high;
};

HullBox boxOf(const PosedHulls& body, std::uint32_t hull) {
    const Mat3 rotation = glm::mat3_cast(body.pose.orientation);
    HullBox box;
    box.hull = hull;
    bool isFirst = true;
    for (const Vec3& vertex : body.hulls[hull].vertices) {
        const Vec3 point = rotation * vertex + body.pose.position;
        box.low = isFirst ? point : glm::min(box.low, point);
        box.high = isFirst ? point : glm::max(box.high, point);
        isFirst = false;
    }
    return box;
}

/// The boxes of all hulls, sorted by their low x.
std::vector<HullBox> boxesOf(std::span<const PosedHulls> bodies) {
    std::vector<HullBox> boxes;
    for (std::uint32_t body = 0; body < bodies.size(); ++body) {
        for (std::uint32_t hull = 0; hull < bodies[body].hulls.size(); ++hull) {
            boxes.push_back(boxOf(bodies[body], hull));
            boxes.back().body = body;
        }
    }
    std::stable_sort(boxes.begin(), boxes.end(), [](const HullBox& a, const HullBox& b) { return a.low.x < b.low.x; });
    return boxes;
}

bool overlapInYz(const HullBox& a, const HullBox& b) {
    return a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

/// Every two hulls that overlap, by their bodies. Adds the number of compared boxes to `compared`.
std::vector<BodyOverlap> hullDepths(std::span<const PosedHulls> bodies, std::size_t& compared) {
    const std::vector<HullBox> boxes = boxesOf(bodies);
    std::vector<BodyOverlap> depths;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t k = i + 1; k < boxes.size() && boxes[k].low.x <= boxes[i].high.x; ++k) {
            ++compared;
            const auto& [a, b] = std::minmax(
                boxes[i], boxes[k], [](const HullBox& left, const HullBox& right) { return left.body < right.body; });
            if (a.body == b.body || !overlapInYz(a, b) || (!bodies[a.body].isDynamic && !bodies[b.body].isDynamic))
                continue;
            const double depth = hullOverlap(bodies[a.body].hulls[a.hull], bodies[a.body].pose,
                                             bodies[b.body].hulls[b.hull], bodies[b.body].pose)
                                     .depth;
            if (depth > 0.0) depths.push_back({a.body, b.body, depth});
        }
    }
    return depths;
}

}  // namespace

std::vector<BodyOverlap> overlapsOf(std::span<const PosedHulls> bodies, std::size_t* compared) {
    std::size_t count = 0;
    std::vector<BodyOverlap> depths = hullDepths(bodies, count);
    if (compared) *compared += count;
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
