#include "core/geometry/polygon/Polygon.h"

#include "core/geometry/polygon/IndexedCorners.h"
#include "core/geometry/polygon/RayCrossings.h"
#include "core/geometry/predicates/Predicates.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace rubble {

namespace {

/// The signed area and first moments of a ring relative to a point.
struct RingMoments {
    double area = 0.0;
    Vec2 moment{0.0, 0.0};  // the integral of position
};

RingMoments momentsOf(std::span<const Vec2> ring, Vec2 reference) {
    RingMoments moments;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 from = ring[i] - reference;
        const Vec2 to = ring[i + 1 == ring.size() ? 0 : i + 1] - reference;
        const double doubleArea = cross(from, to);
        moments.area += doubleArea / 2.0;
        moments.moment += (from + to) * (doubleArea / 6.0);
    }
    return moments;
}

/// The mean of the corners of a ring. Divides once, where meanOf() divides each term: they round differently.
Vec2 meanCorner(std::span<const Vec2> ring) {
    Vec2 sum{0.0, 0.0};
    for (const Vec2 corner : ring) sum += corner - ring[0];
    return ring[0] + sum / static_cast<double>(ring.size());
}

RayCrossings rayCrossings(std::span<const Vec2> ring, Vec2 point) {
    RayCrossings crossings;
    for (std::size_t i = 0; i < ring.size() && !crossings.isOnEdge; ++i)
        crossings.add(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], point);
    return crossings;
}

/// Whether a ring is clockwise, by the orientation at its lexicographically smallest corner, which is on the convex
/// hull: exact also for slivers, whose signed area is lost to rounding.
bool isClockwise(std::span<const Vec2> ring) {
    const std::size_t count = ring.size();
    if (count < 3) return false;
    const auto i =
        static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographicLess) - ring.begin());
    const int orientation = orient2d(ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]);
    return orientation == 0 ? signedArea(ring) < 0.0 : orientation < 0;
}

void reverse(Ring& ring) {
    if (!ring.empty()) std::reverse(ring.begin() + 1, ring.end());
}

}  // namespace

double signedArea(std::span<const Vec2> ring) { return ring.size() < 3 ? 0.0 : momentsOf(ring, ring[0]).area; }

double area(const Polygon& polygon) {
    double sum = std::abs(signedArea(polygon.outer));
    for (const Ring& hole : polygon.holes) sum -= std::abs(signedArea(hole));
    return sum;
}

Vec2 centroid(const Polygon& polygon) {
    if (polygon.outer.empty()) return {0.0, 0.0};
    const Vec2 reference = polygon.outer[0];
    RingMoments sum;
    const auto add = [&](const Ring& ring, double sign) {
        const RingMoments moments = momentsOf(ring, reference);
        const double factor = moments.area < 0.0 ? -sign : sign;
        sum.area += factor * moments.area;
        sum.moment += factor * moments.moment;
    };
    add(polygon.outer, 1.0);
    for (const Ring& hole : polygon.holes) add(hole, -1.0);
    if (sum.area == 0.0) return meanCorner(polygon.outer);
    return reference + sum.moment / sum.area;
}

double perimeter(std::span<const Vec2> ring) {
    double sum = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) sum += glm::distance(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]);
    return sum;
}

double perimeter(const Polygon& polygon) {
    double sum = perimeter(polygon.outer);
    for (const Ring& hole : polygon.holes) sum += perimeter(hole);
    return sum;
}

std::vector<Vec2> cornersOf(const Polygon& polygon) {
    std::vector<Vec2> corners = polygon.outer;
    for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
    return corners;
}

std::vector<std::array<Vec2, 2>> edgesOf(const Polygon& polygon) {
    std::vector<std::array<Vec2, 2>> edges;
    const auto add = [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
    };
    add(polygon.outer);
    for (const Ring& hole : polygon.holes) add(hole);
    return edges;
}

Box2 boundsOf(std::span<const Vec2> points) {
    Box2 box;
    for (const Vec2 point : points) box.include(point);
    return box;
}

Polygon withCanonicalWinding(Polygon polygon) {
    if (isClockwise(polygon.outer)) reverse(polygon.outer);
    for (Ring& hole : polygon.holes)
        if (!isClockwise(hole)) reverse(hole);
    return polygon;
}

Containment containment(const Polygon& polygon, Vec2 point) {
    RayCrossings crossings = rayCrossings(polygon.outer, point);
    if (crossings.isOnEdge) return Containment::OnBoundary;
    bool isInside = crossings.isOdd;
    for (const Ring& hole : polygon.holes) {
        crossings = rayCrossings(hole, point);
        if (crossings.isOnEdge) return Containment::OnBoundary;
        isInside = isInside && !crossings.isOdd;
    }
    return isInside ? Containment::Inside : Containment::Outside;
}

bool isConvex(std::span<const Vec2> ring) {
    const std::size_t count = ring.size();
    for (std::size_t i = 0; i < count; ++i)
        if (orient2d(ring[i], ring[(i + 1) % count], ring[(i + 2) % count]) < 0) return false;
    return true;
}

bool isSimpleAndConvex(std::span<const Vec2> ring) {
    const std::size_t count = ring.size();
    if (count < 3 || !std::all_of(ring.begin(), ring.end(), [](Vec2 point) { return isExactlyUsable(point); }))
        return false;
    int turningPoints = 0;  // corners where the ring reverses its x direction
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 before = ring[i == 0 ? count - 1 : i - 1], here = ring[i], after = ring[i + 1 == count ? 0 : i + 1];
        const bool isTurningPoint = lexicographicLess(before, here) != lexicographicLess(here, after);
        const int orientation = orient2d(before, here, after);
        if (before == here || orientation < 0 || (orientation == 0 && isTurningPoint)) return false;
        turningPoints += isTurningPoint ? 1 : 0;
    }
    return turningPoints == 2;
}

}  // namespace rubble
