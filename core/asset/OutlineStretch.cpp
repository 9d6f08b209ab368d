#include "core/asset/OutlineStretch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

namespace {

/// An edge of the outline, and the ring's length before it.
struct Station {
    Vec2 start{0.0, 0.0};
    Vec2 direction{1.0, 0.0};  // length 1
    double before = 0.0;
    double distance = std::numeric_limits<double>::infinity();

    double along(Vec2 point) const { return before + glm::dot(point - start, direction); }
};

void visitRing(const Ring& ring, Vec2 point, Station& nearest) {
    double before = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
        const double length = glm::length(edge);
        if (!(length > 0.0)) continue;
        const Vec2 direction = edge / length;
        const double reach = std::clamp(glm::dot(point - ring[i], direction), 0.0, length);
        const double distance = glm::distance(point, ring[i] + reach * direction);
        if (distance < nearest.distance) nearest = {ring[i], direction, before, distance};
        before += length;
    }
}

}  // namespace

OutlineStretch outlineStretch(const Polygon& outline, Vec2 a, Vec2 b) {
    const Vec2 middle = a + 0.5 * (b - a);
    Station nearest;
    visitRing(outline.outer, middle, nearest);
    for (const Ring& hole : outline.holes) visitRing(hole, middle, nearest);
    // An outline of the other winding is measured backwards, so that textures are not mirrored.
    const double sign = glm::dot(b - a, nearest.direction) < 0.0 ? -1.0 : 1.0;
    return {sign * nearest.along(a), sign * nearest.along(b), nearest.distance};
}

}  // namespace rubble
