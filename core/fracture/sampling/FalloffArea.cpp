#include "core/fracture/sampling/FalloffArea.h"

#include "core/base/math/Power.h"
#include "core/fracture/sampling/TriangleSampling.h"
#include "core/geometry/polygon/ConvexParts.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// Triangles are bisected until their density varies by at max this factor: four of five points are accepted.
constexpr double kMaxRatio = 1.5;
constexpr double kMaxRadii = 1e30;  // distance at which densities stop decreasing, against overflow

double length(Vec2 vector) { return std::sqrt(vector.x * vector.x + vector.y * vector.y); }

/// Bounds of a triangle's distance from a point.
struct Distances {
    double min = 0.0;
    double max = 0.0;
};

Distances distancesOf(const std::array<Vec2, 3>& corners, Vec2 from) {
    const Vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    double extent = 0.0;
    for (const Vec2 corner : corners) extent = std::max(extent, length(corner - middle));
    const double distance = length(middle - from);
    return {std::max(0.0, distance - extent), distance + extent};
}

}  // namespace

double Falloff::at(double distance) const {
    const double fraction = std::min(distance / radius, kMaxRadii);
    return power(1.0 + fraction * fraction, -falloff / 2.0);
}

Result<FalloffArea> FalloffArea::of(const Polygon& polygon, const Falloff& falloff, const TaskContext& task) {
    const Result<IndexLoops> loops = triangles(polygon);
    if (!loops) return loops.error();
    const std::vector<Vec2> corners = cornersOf(polygon);
    FalloffArea area(falloff);
    area.m_falloff.radius = std::max(falloff.radius, Falloff::kMinRadiusFraction * boundsOf(polygon.outer).diagonal());
    std::vector<Corners> open;
    for (const std::vector<std::uint32_t>& loop : *loops) {
        open.push_back({corners[loop[0]], corners[loop[1]], corners[loop[2]]});
        while (!open.empty()) {
            if (area.m_parts.size() % 1024 == 0 && task.isCancelled()) return TaskContext::cancelled();
            const Corners triangle = open.back();
            open.pop_back();
            const Distances distances = distancesOf(triangle, falloff.centre);
            const double ratio = area.m_falloff.at(distances.min) / area.m_falloff.at(distances.max);
            if (ratio <= kMaxRatio) {
                area.add(triangle);
                continue;
            }
            // Bisects the longest side.
            std::size_t longest = 0;
            const auto side = [&](std::size_t k) { return length(triangle[(k + 1) % 3] - triangle[k]); };
            for (const std::size_t k : {std::size_t{1}, std::size_t{2}})
                longest = side(k) > side(longest) ? k : longest;
            const Vec2 from = triangle[longest], to = triangle[(longest + 1) % 3], apex = triangle[(longest + 2) % 3];
            const Vec2 middle = (from + to) / 2.0;
            open.push_back({from, middle, apex});
            open.push_back({middle, to, apex});
        }
    }
    return area;
}

void FalloffArea::add(const Corners& corners) {
    const double max = m_falloff.at(distancesOf(corners, m_falloff.centre).min);
    const double doubled = std::max(0.0, cross(corners[1] - corners[0], corners[2] - corners[0]));
    m_parts.push_back({corners, max});
    m_weightsUpTo.push_back((m_weightsUpTo.empty() ? 0.0 : m_weightsUpTo.back()) + doubled * max);
}

Vec2 FalloffArea::point(Random& random) const {
    for (;;) {
        const Part& part = m_parts[drawByWeight(m_weightsUpTo, random)];
        const auto& [corner, first, second] = part.corners;
        const Vec2 point = pointOfTriangle(corner, first - corner, second - corner, random);
        if (random.unit() * part.maxDensity < m_falloff.at(length(point - m_falloff.centre))) return point;
    }
}

}  // namespace rubble
