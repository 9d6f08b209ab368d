#include "core/geometry/hull/Diameter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// The corners of the convex hull, its ends twice. Corners that are flat up to rounding may be missing.
std::vector<Vec2> hullCorners(std::vector<Vec2> points) {
    std::ranges::sort(points, [](const Vec2& a, const Vec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
    std::vector<Vec2> hull;
    for (const bool isUpper : {false, true}) {
        const std::size_t begin = hull.size();
        for (const Vec2& point : points) {
            const auto isLeftTurn = [&] {
                const Vec2 last = hull.back() - hull[hull.size() - 2], next = point - hull.back();
                return last.x * next.y - last.y * next.x > 0.0;
            };
            while (hull.size() >= begin + 2 && !isLeftTurn()) hull.pop_back();
            hull.push_back(point);
        }
        if (!isUpper) std::ranges::reverse(points);
    }
    return hull;
}

}  // namespace

double diameterOf(std::vector<Vec2> points) {
    const std::vector<Vec2> hull = hullCorners(std::move(points));
    double diameter = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        for (std::size_t j = i + 1; j < hull.size(); ++j)
            diameter = std::max(diameter, glm::distance(hull[i], hull[j]));
    }
    return diameter;
}

}  // namespace rubble
