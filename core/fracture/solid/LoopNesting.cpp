#include "core/fracture/solid/LoopNesting.h"

#include "core/geometry/polygon/Polygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubble {
namespace {

/// A point inside a simple ring: beside its lowest corner.
Vec2 pointIn(const Ring& ring) {
    const std::size_t count = ring.size();
    const std::size_t lowest =
        static_cast<std::size_t>(std::min_element(ring.begin(), ring.end(), lexicographicLess) - ring.begin());
    const Vec2 before = ring[(lowest + count - 1) % count], corner = ring[lowest], after = ring[(lowest + 1) % count];
    const Polygon triangle = withCanonicalWinding({{before, corner, after}, {}});
    Vec2 deepest = (before + after) / 2.0;
    double depth = 0.0;
    for (const Vec2 other : ring) {
        if (other == before || other == corner || other == after) continue;
        if (containment(triangle, other) == Containment::Outside) continue;
        const double distance = std::abs(cross(after - before, other - before));
        if (distance > depth) depth = distance, deepest = other;
    }
    return (corner + deepest) / 2.0;
}

/// The smallest polygon around a hole; the number of polygons if there is none.
std::size_t ringAround(const std::vector<Polygon>& polygons, const Ring& hole) {
    const Vec2 inside = pointIn(hole);  // not a corner, which may lie on an edge
    std::size_t around = polygons.size();
    for (std::size_t k = 0; k < polygons.size(); ++k) {
        const double area = signedArea(polygons[k].outer);
        // What fills a hole exactly, as another part of the mesh may, is in it, not around it.
        if (area < -(1.0 + 1e-9) * signedArea(hole)) continue;
        if (containment(polygons[k], inside) == Containment::Outside) continue;
        if (around == polygons.size() || area < signedArea(polygons[around].outer)) around = k;
    }
    return around;
}

}  // namespace

std::vector<std::vector<PointLoop>> nestedLoops(std::vector<PointLoop> loops, std::span<const Vec3> points,
                                                const PlaneView& view) {
    std::vector<std::vector<PointLoop>> faces;
    if (loops.size() == 1) {
        faces.push_back(std::move(loops));
        return faces;
    }
    const auto seen = [&](const PointLoop& loop) {
        Ring ring;
        for (const std::uint32_t point : loop) ring.push_back(view(points[point]));
        return ring;
    };
    std::vector<Polygon> rings;
    std::vector<PointLoop> holes;
    for (PointLoop& loop : loops) {
        Ring ring = seen(loop);
        if (signedArea(ring) > 0.0) {
            rings.push_back({std::move(ring), {}});
            faces.push_back({std::move(loop)});
        } else {
            holes.push_back(std::move(loop));
        }
    }
    const std::size_t outerCount = faces.size();
    for (PointLoop& hole : holes) {
        const std::size_t around = ringAround(rings, seen(hole));
        if (around < outerCount)
            faces[around].push_back(std::move(hole));
        else
            faces.push_back({std::move(hole)});
    }
    return faces;
}

}  // namespace rubble
