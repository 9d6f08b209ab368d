#include "core/fracture/solid/SolidPoints.h"

#include "core/base/DisjointSets.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <span>

namespace rubble {
namespace {

using Wide3 = WideInteger<3>;  // differences have 41 bits, their squares 84, crossed 83: at most 170 here
using WideRow = std::array<Wide3, 3>;

WideRow crossed(const WideRow& a, const WideRow& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Wide3 dotted(const WideRow& a, const WideRow& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

WideRow exactOffset(Vec3 from, Vec3 to) {
    const Vec3 offset = to - from;
    return {static_cast<std::int64_t>(offset.x), static_cast<std::int64_t>(offset.y),
            static_cast<std::int64_t>(offset.z)};
}

/// Where an edge from a to b meets the bisector of two sites, from 0 to 1.
double placeOnEdge(Vec3 a, Vec3 b, Vec3 i, Vec3 j) {
    const Int128 atA = solid_signs::exactBisectorValue(a, i, j), atB = solid_signs::exactBisectorValue(b, i, j);
    if (atA == atB) return 0.0;  // both are on the bisector
    return static_cast<double>(atA) / static_cast<double>(atA - atB);
}

/// Where a triangle meets the Voronoi edge of three sites: the weights of its second and third corner.
Vec2 placeInTriangle(const std::array<Vec3, 3>& corners, Vec3 i, Vec3 j, Vec3 k) {
    WideRow ij, ik;
    for (int c = 0; c < 3; ++c) {
        ij[c] = solid_signs::exactBisectorValue(corners[c], i, j);
        ik[c] = solid_signs::exactBisectorValue(corners[c], i, k);
    }
    const WideRow weights = crossed(ij, ik);
    const double scale = (weights[0] + weights[1] + weights[2]).rounded();
    return {weights[1].rounded() / scale, weights[2].rounded() / scale};
}

/// The centre of the sphere through four sites.
Vec3 voronoiCorner(const std::array<Vec3, 4>& site) {
    const WideRow a = exactOffset(site[0], site[1]), b = exactOffset(site[0], site[2]),
                  c = exactOffset(site[0], site[3]);
    const WideRow bc = crossed(b, c), ca = crossed(c, a), ab = crossed(a, b);
    const Wide3 aa = dotted(a, a), bb = dotted(b, b), cc = dotted(c, c);
    const double scale = 2.0 * dotted(a, bc).rounded();
    Vec3 offset(0.0);
    for (int k = 0; k < 3; ++k) offset[k] = (aa * bc[k] + bb * ca[k] + cc * ab[k]).rounded() / scale;
    return site[0] + offset;
}

}  // namespace

SolidPoints solidPoints(const LatticeMesh& mesh, std::span<const Vec3> corners, const SolidDiagram& diagram,
                        const SurfacePieces& pieces, const InnerFaces& faces) {
    SolidPoints points{mesh.corners, {corners.begin(), corners.end()}};
    const auto site = [&](std::uint32_t index) { return diagram.site(index).point; };
    const auto add = [&](Vec3 onLattice, Vec3 placed) {
        points.onLattice.push_back(onLattice);
        points.placed.push_back(placed);
    };
    for (std::size_t e = 0; e < mesh.edges.size(); ++e) {
        const auto [a, b] = mesh.edges[e];
        for (std::uint32_t c = pieces.firstCrossing[e]; c < pieces.firstCrossing[e + 1]; ++c) {
            const EdgeCrossing& crossing = pieces.edgeCrossings[c];
            const double place = placeOnEdge(mesh.corners[a], mesh.corners[b], site(crossing.from), site(crossing.to));
            const auto between = [place](Vec3 from, Vec3 to) { return from + (to - from) * place; };
            add(between(mesh.corners[a], mesh.corners[b]), between(corners[a], corners[b]));
        }
    }
    for (const TriangleCrossing& crossing : pieces.triangleCrossings) {
        const auto& [i, j, k] = diagram.edges()[crossing.edge].site;
        const auto& [a, b, c] = mesh.triangles[crossing.triangle];
        const Vec2 place = placeInTriangle(mesh.cornersOf(crossing.triangle), site(i), site(j), site(k));
        const auto within = [&](std::span<const Vec3> of) {
            return of[a] + ((of[b] - of[a]) * place.x + (of[c] - of[a]) * place.y);
        };
        add(within(mesh.corners), within(corners));
    }
    const std::uint32_t first = surfacePointCount(mesh, pieces);
    const std::vector<Tetrahedralization::Tetrahedron>& tetrahedra = diagram.sites().tetrahedra;
    points.onLattice.resize(first + tetrahedra.size(), Vec3(0.0));
    std::vector<bool> isPlaced(tetrahedra.size());
    for (const PointStep& edge : faces.edges) {
        if (edge.from < first || isPlaced[edge.from - first]) continue;
        const std::array<std::uint32_t, 4>& corner = tetrahedra[edge.from - first].corner;
        points.onLattice[edge.from] =
            voronoiCorner({site(corner[0]), site(corner[1]), site(corner[2]), site(corner[3])});
        isPlaced[edge.from - first] = true;
    }
    points.placed.insert(points.placed.end(), points.onLattice.begin() + first, points.onLattice.end());
    return points;
}

bool coincide(Vec3 a, Vec3 b) {
    const Vec3 apart = glm::abs(a - b);
    return std::max({apart.x, apart.y, apart.z}) <= kSolidWeldDistance;
}

std::vector<std::uint32_t> weldedPoints(std::span<const Vec3> points, const SurfacePieces& pieces,
                                        const InnerFaces& faces) {
    DisjointSets sets(points.size());
    const auto weldEnds = [&](std::uint32_t a, std::uint32_t b) {
        if (coincide(points[a], points[b])) sets.merge(a, b);
    };
    for (std::uint32_t piece = 0; piece < pieces.pieceCount(); ++piece) {
        const std::uint32_t first = pieces.firstCorner[piece], end = pieces.firstCorner[piece + 1];
        for (std::uint32_t c = first; c < end; ++c) {
            weldEnds(pieces.points[c], pieces.points[c + 1 < end ? c + 1 : first]);
        }
    }
    for (const PointStep& edge : faces.edges) weldEnds(edge.from, edge.to);
    return sets.roots();
}

}  // namespace rubble
