#include "core/geometry/hull/HalfSpaceIntersection.h"

#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/search/Box3.h"

#include <glm/geometric.hpp>

#include <vector>

namespace rubble {

std::optional<Polytope> halfSpaceIntersection(std::span<const Plane> planes, Vec3 inside) {
    constexpr double kFlat = 1e-10;  // of the polytope's size: where more than three planes meet but for rounding
    std::vector<Vec3> duals;
    Box3 dualBox;
    for (const Plane& plane : planes) {
        const double distance = plane.offset - glm::dot(plane.normal, inside);
        if (!(distance > 0.0)) return std::nullopt;
        duals.push_back(plane.normal / distance);
        dualBox.include(duals.back());
    }
    const Result<Polytope> dual = convexHull(duals, kFlat * dualBox.diagonal());
    if (!dual) return std::nullopt;
    std::vector<Vec3> corners;
    Box3 box;
    for (const Plane& plane : dual->planes) {
        if (!(plane.offset > 0.0)) return std::nullopt;  // it is not bounded there
        corners.push_back(inside + plane.normal / plane.offset);
        box.include(corners.back());
    }
    Result<Polytope> hull = convexHull(corners, kFlat * box.diagonal());
    return hull ? std::optional(std::move(*hull)) : std::nullopt;
}

}  // namespace rubble
