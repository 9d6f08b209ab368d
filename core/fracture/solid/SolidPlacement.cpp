#include "core/fracture/solid/SolidPlacement.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {
namespace {

/// A plane as the points x with normal · x = offset, and how far a point is from it along the normal.
struct Bisector {
    Vec3 normal;
    double at(Vec3 x) const { return glm::dot(normal, 2.0 * x - sum) / 2.0; }
    Vec3 sum;  // of the sites
};

Bisector bisectorOf(Vec3 i, Vec3 j) { return {j - i, i + j}; }

/// Moves a point to where three planes meet, given its values on them, unless that is far.
void moveOnto(const std::array<Vec3, 3>& normals, const std::array<double, 3>& values, Vec3& point) {
    const Vec3 bc = glm::cross(normals[1], normals[2]), ca = glm::cross(normals[2], normals[0]),
               ab = glm::cross(normals[0], normals[1]);
    const Vec3 move = -(values[0] * bc + values[1] * ca + values[2] * ab) / glm::dot(normals[0], bc);
    if (glm::length(move) <= kTieDistance) point += move;  // not if it is not a number
}

}  // namespace

void placeBetweenSeeds(const LatticeMesh& mesh, std::span<const Vec3> corners, std::span<const Vec3> sites,
                       const SolidDiagram& diagram, const SurfacePieces& pieces, const InnerFaces& facets,
                       std::span<Vec3> placed) {
    std::size_t point = corners.size();
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const Vec3 a = corners[mesh.edges[e][0]], along = corners[mesh.edges[e][1]] - a;
        for (std::uint32_t c = pieces.firstCrossing[e]; c < pieces.firstCrossing[e + 1]; ++c, ++point) {
            const Bisector plane = bisectorOf(sites[pieces.edgeCrossings[c].from], sites[pieces.edgeCrossings[c].to]);
            const double move = -plane.at(placed[point]) / glm::dot(plane.normal, along);
            if (std::abs(move) * glm::length(along) <= kTieDistance) placed[point] += move * along;
        }
    }
    for (const TriangleCrossing& crossing : pieces.triangleCrossings) {
        const auto& [i, j, k] = diagram.edges()[crossing.edge].site;
        const auto& [a, b, c] = mesh.triangles[crossing.triangle];
        const Bisector ij = bisectorOf(sites[i], sites[j]), ik = bisectorOf(sites[i], sites[k]);
        const Vec3 normal = glm::cross(corners[b] - corners[a], corners[c] - corners[a]);
        Vec3& x = placed[point++];
        moveOnto({normal, ij.normal, ik.normal}, {glm::dot(normal, x - corners[a]), ij.at(x), ik.at(x)}, x);
    }
    const std::uint32_t firstVoronoiCorner = static_cast<std::uint32_t>(point);
    std::vector<bool> isMoved(diagram.sites().tetrahedra.size());
    for (const PointStep& edge : facets.edges.items) {
        if (edge.from < firstVoronoiCorner || isMoved[edge.from - firstVoronoiCorner]) continue;
        isMoved[edge.from - firstVoronoiCorner] = true;
        const auto& [i, j, k, m] = diagram.sites().tetrahedra[edge.from - firstVoronoiCorner].corner;
        const std::array<Bisector, 3> planes = {bisectorOf(sites[i], sites[j]), bisectorOf(sites[i], sites[k]),
                                                bisectorOf(sites[i], sites[m])};
        Vec3& x = placed[edge.from];
        moveOnto({planes[0].normal, planes[1].normal, planes[2].normal},
                 {planes[0].at(x), planes[1].at(x), planes[2].at(x)}, x);
    }
}

void placeOnSurface(const LatticeMesh& mesh, std::span<const Vec3> corners, const SurfacePieces& pieces,
                    std::span<const std::uint32_t> welded, std::span<Vec3> placed) {
    std::map<std::uint32_t, std::vector<std::uint32_t>>
        common;  // corners of the supports of all that a point stands for
    const std::uint32_t first = static_cast<std::uint32_t>(mesh.corners.size()), end = surfacePointCount(mesh, pieces);
    for (std::uint32_t point = first; point < end; ++point) {
        const std::uint32_t standing = welded[point];
        if (standing == point || standing < first) continue;
        const auto [it, isNew] = common.try_emplace(standing);
        if (isNew) it->second = supportOf(mesh, pieces, standing);
        const std::vector<std::uint32_t> support = supportOf(mesh, pieces, point);
        std::erase_if(it->second,
                      [&](std::uint32_t corner) { return std::ranges::find(support, corner) == support.end(); });
    }
    for (const auto& [point, support] : common) {
        if (support.empty() || support.size() > 2) continue;
        Vec3 place = corners[support[0]];
        if (support.size() == 2) {
            const Vec3 along = corners[support[1]] - place;
            place += glm::dot(placed[point] - place, along) / glm::dot(along, along) * along;
        }
        // Edges of a triangle without area meet in more than their common corner.
        if (glm::length(place - placed[point]) <= 4.0 * kTieDistance) placed[point] = place;
    }
}

}  // namespace rubble
