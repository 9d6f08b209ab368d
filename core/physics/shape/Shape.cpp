#include "core/physics/shape/Shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {
namespace {

bool isPositive(const MassProperties& mass) {
    const Vec3 moments(mass.inertia[0][0], mass.inertia[1][1], mass.inertia[2][2]);
    const bool isFinite =
        std::isfinite(mass.volume + mass.centre.x + mass.centre.y + mass.centre.z + moments.x + moments.y + moments.z);
    return isFinite && mass.volume > 0.0 && moments.x > 0.0 && moments.y > 0.0 && moments.z > 0.0 &&
           glm::determinant(mass.inertia) > 0.0;
}

double surfaceAreaOf(const Polytope& polytope) {
    double area = 0.0;
    for (const std::vector<std::uint32_t>& face : polytope.faces) {
        Vec3 twice(0.0);
        for (std::size_t k = 2; k < face.size(); ++k) {
            const Vec3& corner = polytope.vertices[face[0]];
            twice += glm::cross(polytope.vertices[face[k - 1]] - corner, polytope.vertices[face[k]] - corner);
        }
        area += glm::length(twice) / 2.0;
    }
    return area;
}

}  // namespace

Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes) {
    std::vector<MassProperties> parts;
    for (const Polytope& polytope : polytopes) parts.push_back(massOf(polytope));
    return makeShape(polytopes, combined(parts));
}

Result<std::shared_ptr<const Shape>> makeShape(std::span<const Polytope> polytopes, const MassProperties& mass) {
    if (polytopes.empty()) return Error{ErrorCode::BadInput, "A body needs at least one hull."};
    if (!isPositive(mass)) {
        return Error{ErrorCode::BadInput, "The volume and inertia of a body must be positive and finite."};
    }
    auto shape = std::make_shared<Shape>();
    shape->mass = mass;
    shape->inverseInertia = glm::inverse(mass.inertia);
    shape->minWidth = std::numeric_limits<float>::infinity();
    for (const Polytope& polytope : polytopes) {
        Result<Hull> hull = makeHull(polytope, mass.centre);
        if (!hull) return hull.error();
        shape->surfaceArea += surfaceAreaOf(polytope);
        shape->boundingRadius = std::max(shape->boundingRadius, hull->boundingRadius);
        shape->extents = componentMax(shape->extents, componentAbs(hull->middle) + hull->extents);
        shape->minWidth = std::min(shape->minWidth, hull->minWidth);
        shape->hulls.push_back(std::move(*hull));
    }
    return std::shared_ptr<const Shape>(std::move(shape));
}

}  // namespace rubble
