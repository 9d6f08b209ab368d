#include "core/fracture/sampling/ScatterArea.h"

#include "core/fracture/sampling/TriangleSampling.h"
#include "core/geometry/polygon/ConvexParts.h"

#include <algorithm>

namespace rubble {

Polygon ScatterArea::domain(const Polygon& outline, ScatterDomain domain) {
    if (domain == ScatterDomain::Outline) return outline;
    const Box2 box = boundsOf(outline.outer);
    return {{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}, {}};
}

Result<ScatterArea> ScatterArea::of(const Polygon& polygon) {
    const Result<IndexLoops> loops = triangles(polygon);
    if (!loops) return loops.error();
    const std::vector<Vec2> corners = cornersOf(polygon);
    ScatterArea area;
    area.m_triangles.reserve(loops->size());
    area.m_areasUpTo.reserve(loops->size());
    double sum = 0.0;
    for (const std::vector<std::uint32_t>& loop : *loops) {
        const Vec2 corner = corners[loop[0]];
        const Triangle triangle{corner, corners[loop[1]] - corner, corners[loop[2]] - corner};
        sum += std::max(0.0, cross(triangle.first, triangle.second) / 2.0);
        area.m_triangles.push_back(triangle);
        area.m_areasUpTo.push_back(sum);
    }
    RUBBLE_ASSERT(!area.m_triangles.empty());
    return area;
}

Vec2 ScatterArea::point(Random& random) const {
    const Triangle& triangle = m_triangles[drawByWeight(m_areasUpTo, random)];
    return pointOfTriangle(triangle.corner, triangle.first, triangle.second, random);
}

}  // namespace rubble
