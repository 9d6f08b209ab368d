#include "core/geometry/mesh/TriangleMesh.h"

#include <glm/geometric.hpp>

namespace rubble {

Vec3 doubleArea(const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = mesh.triangles[triangle];
    return glm::cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

Box3 boundsOf(const TriangleMesh& mesh) {
    Box3 box;
    for (const Vec3 point : mesh.points) box.include(point);
    return box;
}

}  // namespace rubble
