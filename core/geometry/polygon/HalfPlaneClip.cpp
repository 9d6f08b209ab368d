#include "core/geometry/polygon/HalfPlaneClip.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble {

HalfPlane nearerTo(Vec2 site, Vec2 other) {
    const Vec2 normal = other - site;
    return {normal, glm::dot(normal, site + normal / 2.0)};
}

void clipByHalfPlane(std::span<const Vec2> convex, const HalfPlane& halfPlane, Ring& clipped) {
    clipped.clear();
    if (convex.empty()) return;
    const auto excess = [&](Vec2 point) { return glm::dot(halfPlane.normal, point) - halfPlane.offset; };
    const auto append = [&](Vec2 point) {
        if (clipped.empty() || clipped.back() != point) clipped.push_back(point);
    };
    bool hasInside = false;
    Vec2 from = convex.back();
    double fromExcess = excess(from);
    for (const Vec2 to : convex) {
        const double toExcess = excess(to);
        // Always from the inner to the outer corner, so that both cells of an edge compute the same bits.
        if (fromExcess < 0.0 && toExcess > 0.0) append(from + (to - from) * (fromExcess / (fromExcess - toExcess)));
        if (fromExcess > 0.0 && toExcess < 0.0) append(to + (from - to) * (toExcess / (toExcess - fromExcess)));
        if (toExcess <= 0.0) append(to);
        hasInside = hasInside || toExcess < 0.0;
        from = to;
        fromExcess = toExcess;
    }
    while (clipped.size() > 1 && clipped.front() == clipped.back()) clipped.pop_back();
    if (!hasInside || clipped.size() < 3) clipped.clear();
}

}  // namespace rubble
