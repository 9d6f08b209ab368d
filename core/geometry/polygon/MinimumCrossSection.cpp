#include "core/geometry/polygon/MinimumCrossSection.h"

#include "core/base/math/Trigonometry.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace rubble {
namespace {

constexpr int kLines = 180;

/// The intersections of a ring with a line, as positions along it. An end on the line counts as left of it, so that the
/// number of intersections is even.
void addCrossings(const Ring& ring, Vec2 through, Vec2 direction, std::vector<double>& crossings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 from = ring[k] - through;
        const Vec2 to = ring[k + 1 < ring.size() ? k + 1 : 0] - through;
        const double fromSide = cross(direction, from);
        const double toSide = cross(direction, to);
        if ((fromSide < 0.0) == (toSide < 0.0)) continue;
        const double fraction = fromSide / (fromSide - toSide);
        crossings.push_back(glm::dot(direction, from + fraction * (to - from)));
    }
}

}  // namespace

double crossSectionLength(const Polygon& polygon, Vec2 through, Vec2 direction) {
    std::vector<double> crossings;
    addCrossings(polygon.outer, through, direction, crossings);
    for (const Ring& hole : polygon.holes) addCrossings(hole, through, direction, crossings);
    std::ranges::sort(crossings);
    double length = 0.0;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) length += crossings[k + 1] - crossings[k];
    return length;
}

double minimumCrossSection(const Polygon& polygon) {
    const Vec2 centre = centroid(polygon);
    double shortest = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kLines; ++k) {
        const double angle = k * std::numbers::pi / kLines;
        shortest = std::min(shortest, crossSectionLength(polygon, centre, {cosine(angle), sine(angle)}));
    }
    return shortest;
}

}  // namespace rubble
