#include "core/geometry/mesh/MeshContainment.h"

#include "core/geometry/predicates/Predicates.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

std::vector<Box3> boxesOfTriangles(const TriangleMesh& mesh) {
    std::vector<Box3> boxes(mesh.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t) {
        for (const std::uint32_t point : mesh.triangles[t]) boxes[t].include(mesh.points[point]);
    }
    return boxes;
}

/// The side of a point, seen from above, on which an edge passes it: orient2d(), with the point moved by an
/// infinitesimal distance along x and a far smaller one along y, so that no ray meets an edge or a corner. 0 for an
/// edge along the ray.
int sideOf(Vec3 a, Vec3 b, Vec3 point) {
    if (const int side = orient2d(Vec2(a), Vec2(b), Vec2(point)); side != 0) return side;
    if (a.y != b.y) return a.y < b.y ? -1 : 1;
    return a.x == b.x ? 0 : a.x < b.x ? 1 : -1;
}

}  // namespace

MeshContainment::MeshContainment(const TriangleMesh& mesh)
    : m_mesh(mesh), m_top(boundsOf(mesh).max.z), m_tree(boxesOfTriangles(mesh)) {}

MeshContainment::Passage MeshContainment::passageAbove(std::uint32_t triangle, Vec3 point) const {
    const auto& [i, j, k] = m_mesh.triangles[triangle];
    const Vec3 a = m_mesh.points[i], b = m_mesh.points[j], c = m_mesh.points[k];
    const int side = orient3d(a, b, c, point);
    if (side == 0) {
        // In the plane: on the triangle if it is on no outer side of an edge, seen along any axis.
        bool isOutside = false;
        for (int axis = 0; axis < 3; ++axis) {
            const auto seen = [axis](Vec3 p) { return Vec2(p[(axis + 1) % 3], p[(axis + 2) % 3]); };
            const int turn = orient2d(seen(a), seen(b), seen(c));
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                isOutside = isOutside || turn * orient2d(seen(from), seen(to), seen(point)) < 0;
            }
        }
        const bool isInBox = glm::all(glm::lessThanEqual(glm::min(a, glm::min(b, c)), point)) &&
                             glm::all(glm::lessThanEqual(point, glm::max(a, glm::max(b, c))));
        if (!isOutside && isInBox) return Passage::Touching;
    }
    const int ab = sideOf(a, b, point), bc = sideOf(b, c, point), ca = sideOf(c, a, point);
    if (ab == 0 || ab != bc || bc != ca) return Passage::Beside;
    // Counter-clockwise from above, the triangle is above a point that orient3d() has below.
    return side * ab > 0 ? Passage::Through : Passage::Beside;
}

Containment MeshContainment::containment(Vec3 point) const {
    Box3 above;
    above.include(point);
    above.include(Vec3(point.x, point.y, std::max(point.z, m_top)));
    bool isInside = false, isTouching = false;
    m_tree.visitOverlapping(above, [&](std::uint32_t triangle) {
        const Passage passage = passageAbove(triangle, point);
        isInside = isInside != (passage == Passage::Through);
        isTouching = isTouching || passage == Passage::Touching;
    });
    if (isTouching) return Containment::OnBoundary;
    return isInside ? Containment::Inside : Containment::Outside;
}

}  // namespace rubble
