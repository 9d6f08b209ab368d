#include "app/thesis/ThesisMethod.h"

#include <algorithm>
#include <cmath>
#include <map>

// A literal implementation, which keeps the errors visible: floating-point tests without exact signs, a linear search
// of the triangulation for every seed, and libm's atan2, which is not allowed elsewhere.

namespace rubble {
namespace {

constexpr double kSuperTriangleScale = 20.0;
constexpr double kUnboundedLength = 10.0;

using Corners = std::array<std::uint32_t, 3>;
using Edge = std::array<std::uint32_t, 2>;  // lower index first

struct CircledTriangle {
    Corners corners;
    Vec2 centre;
    double radiusSquared;
};

CircledTriangle circled(const Corners& corners, std::span<const Vec2> points) {
    const Vec2 a = points[corners[0]];
    const Vec2 b = points[corners[1]] - a;
    const Vec2 c = points[corners[2]] - a;
    const double twice = 2.0 * cross(b, c);
    const Vec2 centre =
        Vec2{c.y * squaredLength(b) - b.y * squaredLength(c), b.x * squaredLength(c) - c.x * squaredLength(b)} / twice;
    return {corners, a + centre, squaredLength(centre)};
}

Edge edgeOf(const Corners& corners, std::size_t k) {
    const std::uint32_t from = corners[k];
    const std::uint32_t to = corners[(k + 1) % 3];
    return {std::min(from, to), std::max(from, to)};
}

/// Listing 2.
std::array<Vec2, 3> superTriangle(std::span<const Vec2> seeds) {
    const Box2 box = boundsOf(seeds);
    const Vec2 middle = (box.min + box.max) / 2.0;
    const double deltaMax = std::max(box.size().x, box.size().y);
    const double extent = deltaMax * kSuperTriangleScale;
    return {Vec2{middle.x, middle.y + extent}, Vec2{middle.x - extent, middle.y - deltaMax},
            Vec2{middle.x + extent, middle.y - deltaMax}};
}

/// Listing 1, the loop over one point.
void insert(std::uint32_t point, std::span<const Vec2> points, std::vector<CircledTriangle>& triangulation) {
    std::map<Edge, int> uses;
    const auto isBad = [&](const CircledTriangle& triangle) {
        return squaredLength(points[point] - triangle.centre) < triangle.radiusSquared;
    };
    for (const CircledTriangle& triangle : triangulation) {
        if (!isBad(triangle)) continue;
        for (std::size_t k = 0; k < 3; ++k) ++uses[edgeOf(triangle.corners, k)];
    }
    std::erase_if(triangulation, isBad);
    for (const auto& [edge, count] : uses) {
        if (count == 1) triangulation.push_back(circled({edge[0], edge[1], point}, points));
    }
}

/// Listing 1.
std::vector<CircledTriangle> bowyerWatson(std::span<const Vec2> seeds) {
    const std::uint32_t count = static_cast<std::uint32_t>(seeds.size());
    std::vector<Vec2> points(seeds.begin(), seeds.end());
    const std::array<Vec2, 3> super = superTriangle(seeds);
    points.insert(points.end(), super.begin(), super.end());
    std::vector<CircledTriangle> triangulation{circled({count, count + 1, count + 2}, points)};
    for (std::uint32_t point = 0; point < count; ++point) insert(point, points, triangulation);
    std::erase_if(triangulation, [&](const CircledTriangle& triangle) {
        return std::ranges::any_of(triangle.corners, [&](std::uint32_t corner) { return corner >= count; });
    });
    return triangulation;
}

/// Listing 4: where the ray over an edge with one triangle ends.
Vec2 unboundedEnd(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 along = b - a;
    const Vec2 d = a + along * (glm::dot(c - a, along) / squaredLength(along));
    const Vec2 direction = glm::normalize(c - d);
    const Vec2 first = c + direction * kUnboundedLength;
    const Vec2 second = c - direction * kUnboundedLength;
    return glm::length(first) < glm::length(second) ? second : first;
}

/// Listing 3 for one seed: the ends of the duals of its edges.
std::vector<Vec2> cellCorners(std::uint32_t seed, std::span<const Vec2> seeds,
                              std::span<const CircledTriangle> triangulation) {
    std::map<Edge, std::vector<Vec2>> centresAtEdge;
    for (const CircledTriangle& triangle : triangulation) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge = edgeOf(triangle.corners, k);
            if (edge[0] == seed || edge[1] == seed) centresAtEdge[edge].push_back(triangle.centre);
        }
    }
    std::vector<Vec2> corners;
    for (const auto& [edge, centres] : centresAtEdge) {
        corners.insert(corners.end(), centres.begin(), centres.end());
        if (centres.size() == 1) corners.push_back(unboundedEnd(seeds[edge[0]], seeds[edge[1]], centres[0]));
    }
    return corners;
}

/// Listing 5. Corners that are no numbers cannot be sorted; they are left as they are.
void sortCounterClockwise(std::vector<Vec2>& corners) {
    Vec2 centre{0.0, 0.0};
    for (const Vec2 corner : corners) centre += corner / static_cast<double>(corners.size());
    if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return;
    std::ranges::sort(corners, {}, [&](Vec2 corner) { return std::atan2(corner.y - centre.y, corner.x - centre.x); });
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
}

/// Sutherland and Hodgman against one side of the box: what has coordinate `axis` below `limit`, or above it for a
/// negative sign. The ring need not be convex; then the result may be wrong, as there.
Ring clippedToSide(const Ring& ring, int axis, double limit, double sign) {
    Ring clipped;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 from = ring[k];
        const Vec2 to = ring[(k + 1) % ring.size()];
        const double fromInside = sign * (limit - from[axis]);
        const double toInside = sign * (limit - to[axis]);
        if (!(fromInside < 0.0)) clipped.push_back(from);
        if ((fromInside < 0.0) != (toInside < 0.0)) {
            clipped.push_back(from + (to - from) * (fromInside / (fromInside - toInside)));
        }
    }
    return clipped;
}

Ring clippedToBox(Ring ring, const Box2& box) {
    for (const int axis : {0, 1}) {
        ring = clippedToSide(ring, axis, box.min[axis], -1.0);
        ring = clippedToSide(ring, axis, box.max[axis], 1.0);
    }
    return ring;
}

}  // namespace

ThesisDiagram thesisDiagram(std::span<const Vec2> outline, std::span<const Vec2> seeds) {
    ThesisDiagram diagram;
    diagram.cells.resize(seeds.size());
    if (seeds.empty()) return diagram;
    const std::vector<CircledTriangle> triangulation = bowyerWatson(seeds);
    for (const CircledTriangle& triangle : triangulation) diagram.triangles.push_back(triangle.corners);
    const Box2 box = boundsOf(outline);
    for (std::uint32_t seed = 0; seed < seeds.size(); ++seed) {
        std::vector<Vec2> corners = cellCorners(seed, seeds, triangulation);
        sortCounterClockwise(corners);
        diagram.cells[seed] = clippedToBox(std::move(corners), box);
    }
    return diagram;
}

}  // namespace rubble
