#include "core/fracture/solid/SolidPoints.h"

#include "core/base/DisjointSets.h"
#include "core/base/Parallel.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

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

/// Places points in chunks, each of which is skipped once the task is cancelled.
class PointBuilder {
public:
    PointBuilder(const LatticeMesh& mesh, std::span<const Vec3> corners, const SolidDiagram& diagram,
                 const SurfacePieces& pieces, const TaskContext& task)
        : m_mesh(mesh), m_corners(corners), m_diagram(diagram), m_pieces(pieces), m_task(task) {
        const std::size_t count = surfacePointCount(mesh, pieces) + diagram.sites().tetrahedra.size();
        points.onLattice.resize(count);
        points.placed.resize(count);
    }

    void placeSurface() {
        forEachChunk(m_corners.size(), [this](std::size_t c) { put(c, m_mesh.corners[c], m_corners[c]); });
        forEachChunk(m_mesh.edges.size(), [this](std::size_t edge) { placeEdgeCrossings(edge); });
        forEachChunk(m_pieces.triangleCrossings.size(), [this](std::size_t c) { placeTriangleCrossing(c); });
    }

    /// Only the corners that faces have.
    void placeVoronoiCorners(const InnerFaces& faces) {
        const std::uint32_t first = surfacePointCount(m_mesh, m_pieces);
        const std::vector<Tetrahedralization::Tetrahedron>& tetrahedra = m_diagram.sites().tetrahedra;
        std::vector<std::uint8_t> isUsed(tetrahedra.size(), 0);
        for (const PointStep& edge : faces.edges.items) {
            if (edge.from >= first) isUsed[edge.from - first] = 1;
        }
        forEachChunk(tetrahedra.size(), [&](std::size_t t) {
            const std::array<std::uint32_t, 4>& corner = tetrahedra[t].corner;
            const Vec3 place = isUsed[t]
                                   ? voronoiCorner({site(corner[0]), site(corner[1]), site(corner[2]), site(corner[3])})
                                   : Vec3(0.0);
            put(first + t, place, place);
        });
    }

    SolidPoints points;

private:
    template <class Work>
    void forEachChunk(std::size_t count, const Work& work) const {
        constexpr std::size_t kChunk = 1024;
        forEachIndex((count + kChunk - 1) / kChunk, m_task.threads, [&](std::size_t chunk) {
            if (m_task.isCancelled()) return;
            const std::size_t end = std::min((chunk + 1) * kChunk, count);
            for (std::size_t k = chunk * kChunk; k < end; ++k) work(k);
        });
    }

    Vec3 site(std::uint32_t index) const { return m_diagram.site(index).point; }
    void put(std::size_t point, Vec3 onLattice, Vec3 placed) {
        points.onLattice[point] = onLattice;
        points.placed[point] = placed;
    }

    void placeEdgeCrossings(std::size_t edge) {
        const auto [a, b] = m_mesh.edges[edge];
        for (std::uint32_t c = m_pieces.firstCrossing[edge]; c < m_pieces.firstCrossing[edge + 1]; ++c) {
            const auto& [from, to] = m_pieces.edgeCrossings[c];
            const double place = placeOnEdge(m_mesh.corners[a], m_mesh.corners[b], site(from), site(to));
            const auto between = [place](Vec3 start, Vec3 end) { return start + (end - start) * place; };
            put(m_corners.size() + c, between(m_mesh.corners[a], m_mesh.corners[b]),
                between(m_corners[a], m_corners[b]));
        }
    }

    void placeTriangleCrossing(std::size_t index) {
        const TriangleCrossing& crossing = m_pieces.triangleCrossings[index];
        const auto& [i, j, k] = m_diagram.edges()[crossing.edge].site;
        const auto& [a, b, c] = m_mesh.triangles[crossing.triangle];
        const Vec2 place = placeInTriangle(m_mesh.cornersOf(crossing.triangle), site(i), site(j), site(k));
        const auto within = [&](std::span<const Vec3> of) {
            return of[a] + ((of[b] - of[a]) * place.x + (of[c] - of[a]) * place.y);
        };
        put(m_corners.size() + m_pieces.edgeCrossings.size() + index, within(m_mesh.corners), within(m_corners));
    }

    const LatticeMesh& m_mesh;
    std::span<const Vec3> m_corners;
    const SolidDiagram& m_diagram;
    const SurfacePieces& m_pieces;
    const TaskContext& m_task;
};

}  // namespace

Result<SolidPoints> solidPoints(const LatticeMesh& mesh, std::span<const Vec3> corners, const SolidDiagram& diagram,
                                const SurfacePieces& pieces, const InnerFaces& faces, const TaskContext& task) {
    PointBuilder builder(mesh, corners, diagram, pieces, task);
    builder.placeSurface();
    builder.placeVoronoiCorners(faces);
    if (task.isCancelled()) return TaskContext::cancelled();
    return std::move(builder.points);
}

bool coincide(Vec3 a, Vec3 b) {
    const Vec3 apart = glm::abs(a - b);
    return std::max({apart.x, apart.y, apart.z}) <= kSolidWeldDistance;
}

std::vector<std::uint32_t> weldedPoints(std::span<const Vec3> points, const SurfacePieces& pieces,
                                        const InnerFaces& faces, const TaskContext& task) {
    constexpr std::size_t kChunk = 1024;  // pieces or edges
    const auto chunksOf = [](std::size_t count) { return (count + kChunk - 1) / kChunk; };
    const std::size_t edgeChunks = chunksOf(faces.edges.items.size());
    std::vector<std::vector<PointStep>> welds(edgeChunks + chunksOf(pieces.pieceCount()));
    forEachIndex(welds.size(), task.threads, [&](std::size_t chunk) {
        if (task.isCancelled()) return;
        const auto weldEnds = [&](const PointStep& edge) {
            if (coincide(points[edge.from], points[edge.to])) welds[chunk].push_back(edge);
        };
        if (chunk < edgeChunks) {
            const std::size_t end = std::min((chunk + 1) * kChunk, faces.edges.items.size());
            for (std::size_t e = chunk * kChunk; e < end; ++e) weldEnds(faces.edges.items[e]);
            return;
        }
        const std::size_t begin = (chunk - edgeChunks) * kChunk;
        for (std::size_t piece = begin; piece < std::min<std::size_t>(begin + kChunk, pieces.pieceCount()); ++piece) {
            const std::uint32_t first = pieces.firstCorner[piece], last = pieces.firstCorner[piece + 1] - 1;
            for (std::uint32_t c = first, before = last; c <= last; before = c++) {
                weldEnds({pieces.points[before], pieces.points[c]});
            }
        }
    });
    if (task.isCancelled()) return {};
    DisjointSets sets(points.size());
    for (const std::vector<PointStep>& chunk : welds) {
        for (const PointStep& edge : chunk) sets.merge(edge.from, edge.to);
    }
    return sets.roots();
}

}  // namespace rubble
