#include "bench/solid/SolidPeers.h"

#include "core/fracture/solid/SolidCut.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace rubble::bench {
namespace {

TriangleMesh boxMesh(const Box3& box) {
    TriangleMesh mesh;
    for (int k = 0; k < 8; ++k) {
        const auto at = [&](int axis) { return (k >> axis & 1) == 0 ? box.min[axis] : box.max[axis]; };
        mesh.points.push_back({at(0), at(1), at(2)});
    }
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

}  // namespace

std::vector<ConvexCell> cellsAround(const TriangleMesh& mesh, std::span<const Vec3> seeds) {
    constexpr double kMargin = 0.01;  // of the box
    Box3 box = boundsOf(mesh);
    const Vec3 margin = kMargin * (box.max - box.min);
    box.min -= margin, box.max += margin;
    const SolidPartition partition = *cutSolid(boxMesh(box), seeds);
    std::vector<ConvexCell> cells(partition.fragmentCount());
    for (std::uint32_t fragment = 0; fragment < cells.size(); ++fragment) {
        const std::uint32_t seed = partition.seedOfFragment[fragment];
        std::vector<std::uint32_t> corners;
        for (const SolidPartition::FaceSide& side : partition.facesOf(fragment)) {
            for (const auto& triangle : partition.trianglesOf(side.face)) {
                corners.insert(corners.end(), triangle.begin(), triangle.end());
            }
            const SolidPartition::Face& face = partition.faces[side.face];
            if (face.behind == kNone) continue;
            const Vec3 other = seeds[partition.seedOfFragment[side.isReversed ? face.fragment : face.behind]];
            const Vec3 normal = glm::normalize(other - seeds[seed]);
            cells[fragment].planes.push_back({normal, glm::dot(normal, (other + seeds[seed]) / 2.0)});
        }
        std::ranges::sort(corners);
        corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
        for (const std::uint32_t corner : corners) {
            cells[fragment].corners.push_back(partition.origin + partition.points[corner]);
        }
    }
    return cells;
}

}  // namespace rubble::bench
