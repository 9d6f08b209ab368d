#include "core/geometry/CornerSectors.h"

#include "core/geometry/Predicates.h"

#include <algorithm>
#include <span>

namespace rubble {

namespace {

/// One end of an edge, seen from the point where it lies.
struct Ray {
    std::uint32_t corner;  // that it leaves, or the one before the corner that it reaches
    Vec2 tip;
    bool isLeaving;
};

/// Sorts rays counter-clockwise around a point, beginning straight down.
void sortAround(Vec2 centre, std::vector<Ray>& rays) {
    const auto isBefore = [&](const Ray& a, const Ray& b) {
        const bool isRightA = sweepsBefore(centre, a.tip), isRightB = sweepsBefore(centre, b.tip);
        return isRightA == isRightB ? orient2d(centre, a.tip, b.tip) > 0 : isRightA;
    };
    std::sort(rays.begin(), rays.end(), isBefore);
}

/// The interior lies left of every edge: around the point it begins at an edge that leaves and ends at one that arrives.
bool partSectorsAt(std::span<const std::uint32_t> meeting, NumberedCorners& corners) {
    std::vector<Ray> rays;
    for (const std::uint32_t corner : meeting) {
        const std::uint32_t before = corners.previous[corner];
        rays.push_back({corner, corners.points[corners.next[corner]], true});
        rays.push_back({before, corners.points[before], false});
    }
    sortAround(corners.points[meeting[0]], rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& leaving = rays[i];
        const Ray& arriving = rays[(i + 1) % rays.size()];
        if (leaving.isLeaving == arriving.isLeaving) return false;
        if (!leaving.isLeaving) continue;
        corners.previous[leaving.corner] = arriving.corner;
        corners.next[arriving.corner] = leaving.corner;
    }
    return true;
}

}  // namespace

bool partSectors(NumberedCorners& corners) {
    const std::vector<std::uint32_t> order = sweepOrder(corners);
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && corners.points[order[end]] == corners.points[order[begin]]) ++end;
        if (end - begin > 1 && !partSectorsAt(std::span(order).subspan(begin, end - begin), corners)) return false;
    }
    return true;
}

}  // namespace rubble
