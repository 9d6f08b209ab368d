#include "core/geometry/TriangleMesh.h"

#include <glm/geometric.hpp>

namespace rubble {

Vec3 doubleArea(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = mesh.triangles[triangle];
    return glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

double Box3::diagonal() const { return min.x > max.x ? 0.0 : glm::length(max - min); }

Box3 boundsOf(const TriangleMesh& mesh) {
    Box3 box;
    for (const Vec3 point : mesh.points) {
        box.min = glm::min(box.min, point);
        box.max = glm::max(box.max, point);
    }
    return box;
}

}  // namespace rubble
