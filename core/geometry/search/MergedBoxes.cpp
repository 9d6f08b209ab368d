#include "core/geometry/search/MergedBoxes.h"

#include "core/base/DisjointSets.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

bool isBefore(const Box3& a, const Box3& b) {
    return std::tie(a.min.x, a.min.y, a.min.z, a.max.x, a.max.y, a.max.z) <
           std::tie(b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z);
}

bool overlapAcross(const Box3& a, const Box3& b) {
    return a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z && b.min.z <= a.max.z;
}

/// The boxes around those that are connected by overlaps; `boxes` are sorted by min.x.
std::vector<Box3> mergedOnce(const std::vector<Box3>& boxes) {
    DisjointSets groups(boxes.size());
    std::vector<std::uint32_t> open;  // those that the sweep along x has not left
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        std::erase_if(open, [&](std::uint32_t other) { return boxes[other].max.x < boxes[k].min.x; });
        for (const std::uint32_t other : open) {
            if (overlapAcross(boxes[k], boxes[other])) groups.merge(k, other);
        }
        open.push_back(k);
    }
    std::vector<Box3> around(boxes.size());
    for (std::uint32_t k = 0; k < boxes.size(); ++k) around[groups.rootOf(k)].include(boxes[k]);
    std::erase_if(around, [](const Box3& box) { return box.isEmpty(); });
    return around;
}

}  // namespace

std::vector<Box3> mergedBoxes(std::vector<Box3> boxes) {
    std::erase_if(boxes, [](const Box3& box) { return box.isEmpty(); });
    for (std::size_t count = boxes.size() + 1; boxes.size() < count;) {
        count = boxes.size();
        std::ranges::sort(boxes, isBefore);
        boxes = mergedOnce(boxes);
    }
    std::ranges::sort(boxes, isBefore);
    return boxes;
}

}  // namespace rubble
