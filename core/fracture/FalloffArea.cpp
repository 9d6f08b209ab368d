#include "core/fracture/FalloffArea.h"

#include "core/base/Power.h"
#include "core/geometry/ConvexParts.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// A triangle is halved until its density changes by no more than this factor: four points of five are kept.
constexpr double kMostRatio = 1.5;
constexpr double kLeastShare = 1e-6;  // of the diameter: the least radius
constexpr double kFarthest = 1e30;    // radii: beyond it densities stay as they are, above what doubles can hold

double length(Vec2 vector) { return std::sqrt(vector.x * vector.x + vector.y * vector.y); }

/// Between which distances from a point a triangle lies, or a little wider.
struct Distances {
    double least = 0.0;
    double most = 0.0;
};

Distances distancesOf(const std::array<Vec2, 3>& corners, Vec2 from) {
    const Vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    double reach = 0.0;
    for (const Vec2 corner : corners) reach = std::max(reach, length(corner - middle));
    const double distance = length(middle - from);
    return {std::max(0.0, distance - reach), distance + reach};
}

std::vector<Vec2> cornersOf(const Polygon& polygon) {
    std::vector<Vec2> corners = polygon.outer;
    for (const Ring& hole : polygon.holes) corners.insert(corners.end(), hole.begin(), hole.end());
    return corners;
}

}  // namespace

double Falloff::at(double distance) const {
    const double share = std::min(distance / radius, kFarthest);
    return power(1.0 + share * share, -falloff / 2.0);
}

Result<FalloffArea> FalloffArea::of(const Polygon& polygon, const Falloff& falloff, const TaskContext& task) {
    const Result<IndexLoops> loops = triangles(polygon);
    if (!loops) return loops.error();
    const std::vector<Vec2> corners = cornersOf(polygon);
    FalloffArea area(falloff);
    area.m_falloff.radius = std::max(falloff.radius, kLeastShare * boundsOf(polygon.outer).diagonal());
    std::vector<Corners> open;
    for (const std::vector<std::uint32_t>& loop : *loops) {
        open.push_back({corners[loop[0]], corners[loop[1]], corners[loop[2]]});
        while (!open.empty()) {
            if (area.m_parts.size() % 1024 == 0 && task.isCancelled()) return TaskContext::cancelled();
            const Corners triangle = open.back();
            open.pop_back();
            const Distances distances = distancesOf(triangle, falloff.centre);
            const double ratio = area.m_falloff.at(distances.least) / area.m_falloff.at(distances.most);
            if (ratio <= kMostRatio) {
                area.add(triangle);
                continue;
            }
            // In two at the middle of its longest side.
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
    const double most = m_falloff.at(distancesOf(corners, m_falloff.centre).least);
    const double doubled = std::max(0.0, cross(corners[1] - corners[0], corners[2] - corners[0]));
    m_parts.push_back({corners, most});
    m_weightsUpTo.push_back((m_weightsUpTo.empty() ? 0.0 : m_weightsUpTo.back()) + doubled * most);
}

Vec2 FalloffArea::point(Random& random) const {
    for (;;) {
        const double chosen = random.unit() * m_weightsUpTo.back();
        const auto found = std::ranges::upper_bound(m_weightsUpTo, chosen) - m_weightsUpTo.begin();
        const Part& part = m_parts[std::min(m_parts.size() - 1, static_cast<std::size_t>(found))];
        const auto& [corner, first, second] = part.corners;
        double u = random.unit();
        double v = random.unit();
        if (u + v > 1.0) {  // the other half of the parallelogram, turned onto the triangle
            u = 1.0 - u;
            v = 1.0 - v;
        }
        const Vec2 point = corner + u * (first - corner) + v * (second - corner);
        if (random.unit() * part.most < m_falloff.at(length(point - m_falloff.centre))) return point;
    }
}

}  // namespace rubble
