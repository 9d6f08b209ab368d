#include "core/geometry/polygon/TouchingCorners.h"

#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <span>

namespace rubble {

namespace {

/// An edge at a point.
struct Spoke {
    std::uint32_t corner;  // where the edge starts
    Vec2 tip;              // the other end
    bool isOutgoing;
};

/// Sorts spokes counter-clockwise around a point, starting straight down.
void sortAround(Vec2 centre, std::vector<Spoke>& spokes) {
    const auto isBefore = [&](const Spoke& a, const Spoke& b) {
        const bool isRightA = lexicographicLess(centre, a.tip), isRightB = lexicographicLess(centre, b.tip);
        return isRightA == isRightB ? orient2d(centre, a.tip, b.tip) > 0 : isRightA;
    };
    std::sort(spokes.begin(), spokes.end(), isBefore);
}

/// The interior is to the left of every edge: counter-clockwise around the point, each sector starts at an outgoing
/// edge and ends at an incoming one.
bool splitAt(std::span<const std::uint32_t> coinciding, IndexedCorners& corners) {
    std::vector<Spoke> spokes;
    for (const std::uint32_t corner : coinciding) {
        const std::uint32_t before = corners.previous[corner];
        spokes.push_back({corner, corners.points[corners.next[corner]], true});
        spokes.push_back({before, corners.points[before], false});
    }
    sortAround(corners.points[coinciding[0]], spokes);
    for (std::size_t i = 0; i < spokes.size(); ++i) {
        const Spoke& outgoing = spokes[i];
        const Spoke& incoming = spokes[(i + 1) % spokes.size()];
        if (outgoing.isOutgoing == incoming.isOutgoing) return false;
        if (!outgoing.isOutgoing) continue;
        corners.previous[outgoing.corner] = incoming.corner;
        corners.next[incoming.corner] = outgoing.corner;
    }
    return true;
}

}  // namespace

bool splitTouchingCorners(IndexedCorners& corners) {
    const std::vector<std::uint32_t> order = sweepOrder(corners);
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && corners.points[order[end]] == corners.points[order[begin]]) ++end;
        if (end - begin > 1 && !splitAt(std::span(order).subspan(begin, end - begin), corners)) return false;
    }
    return true;
}

}  // namespace rubble
