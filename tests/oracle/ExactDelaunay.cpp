#include "tests/oracle/ExactDelaunay.h"

#include "tests/oracle/RationalConvex.h"

#include <CGAL/Delaunay_triangulation_2.h>

#include <algorithm>

namespace rubble::oracle {
namespace {

using InputPoint = Predicates::Point_2;

std::string named(const std::array<std::uint32_t, 3>& triangle) {
    return "triangle (" + std::to_string(triangle[0]) + ", " + std::to_string(triangle[1]) + ", " +
           std::to_string(triangle[2]) + ")";
}

/// The number of triangles; 0 if all points are collinear.
std::size_t expectedCount(const std::vector<InputPoint>& points) {
    const CGAL::Delaunay_triangulation_2<Predicates> triangulation(points.begin(), points.end());
    return triangulation.dimension() == 2 ? triangulation.number_of_faces() : 0;
}

std::optional<std::string> triangleFault(const std::array<std::uint32_t, 3>& triangle,
                                         const std::vector<InputPoint>& points) {
    for (const std::uint32_t corner : triangle)
        if (corner >= points.size()) return named(triangle) + " refers to a seed that does not exist";
    const InputPoint& a = points[triangle[0]];
    const InputPoint& b = points[triangle[1]];
    const InputPoint& c = points[triangle[2]];
    if (CGAL::orientation(a, b, c) != CGAL::LEFT_TURN) return named(triangle) + " is not counter-clockwise";
    std::uint32_t lowest = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t seed = 0; seed < points.size(); ++seed) {
        const auto side = CGAL::side_of_oriented_circle(a, b, c, points[seed]);
        if (side == CGAL::ON_POSITIVE_SIDE)
            return named(triangle) + " has seed " + std::to_string(seed) + " in its circle";
        if (side == CGAL::ON_ORIENTED_BOUNDARY) lowest = std::min(lowest, seed);
    }
    if (std::find(triangle.begin(), triangle.end(), lowest) == triangle.end())
        return named(triangle) + " does not have seed " + std::to_string(lowest) +
               ", the lowest on its circle, as a corner";
    return std::nullopt;
}

}  // namespace

std::optional<std::string> delaunayFault(std::span<const std::array<std::uint32_t, 3>> triangles,
                                         std::span<const Vec2> seeds) {
    std::vector<InputPoint> points;
    for (const Vec2 seed : seeds) points.emplace_back(seed.x, seed.y);
    if (const std::size_t count = expectedCount(points); triangles.size() != count)
        return std::to_string(triangles.size()) + " triangles instead of " + std::to_string(count);
    if (!std::is_sorted(triangles.begin(), triangles.end()) ||
        std::adjacent_find(triangles.begin(), triangles.end()) != triangles.end())
        return "the triangles are not sorted, or one occurs twice";
    for (const auto& triangle : triangles)
        if (auto fault = triangleFault(triangle, points)) return fault;
    return std::nullopt;
}

}  // namespace rubble::oracle
