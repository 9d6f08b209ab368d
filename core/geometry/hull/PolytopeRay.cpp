#include "core/geometry/hull/PolytopeRay.h"

#include <limits>

namespace rubble {

std::optional<PolytopeRayHit> castRay(const Polytope& polytope, const Ray& ray) {
    double enters = -std::numeric_limits<double>::infinity(), leaves = std::numeric_limits<double>::infinity();
    PolytopeRayHit entry;
    for (const Plane& plane : polytope.planes) {
        const double above = glm::dot(plane.normal, ray.from) - plane.offset;
        const double pace = glm::dot(plane.normal, ray.direction);
        if (pace == 0.0) {
            if (above > 0.0) return std::nullopt;
            continue;
        }
        const double distance = -above / pace;
        if (pace > 0.0) {
            leaves = std::min(leaves, distance);
        } else if (distance > enters) {
            enters = distance;
            entry.normal = plane.normal;
        }
    }
    if (enters > leaves || enters < 0.0) return std::nullopt;
    entry.distance = enters;
    return entry;
}

}  // namespace rubble
