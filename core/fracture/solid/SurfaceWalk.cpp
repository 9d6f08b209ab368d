#include "core/fracture/solid/SurfaceWalk.h"

#include "core/base/Assert.h"
#include "core/base/Groups.h"
#include "core/base/Parallel.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rubble {
namespace {

constexpr std::size_t kChunk = 512;  // triangles, edges or corners at a time

std::size_t chunksOf(std::size_t count) { return (count + kChunk - 1) / kChunk; }

/// Whether a point is within kTieDistance of the bisector of two sites, by the value of their h there.
bool isTied(const BoundedDouble& value, Vec3 i, Vec3 j) {
    const Vec3 apart = glm::abs(j - i);  // h grows by twice their distance a step, at most the sum of these
    return std::abs(value.value) <= 2.0 * kTieDistance * (apart.x + apart.y + apart.z);
}

/// The bisector between the cell that a triangle is clipped to and a neighbour, with its values at the corners.
struct TriangleBisector {
    SolidDiagram::Neighbour neighbour;
    std::array<BoundedDouble, 3> value;
};

/// A side of a clipped triangle: one of its edges, or a bisector.
struct Side {
    std::int32_t edge = -1;      // 0, 1, 2 of the triangle; -1: a bisector
    std::uint32_t bisector = 0;  // index
};

/// Clips a triangle to the cell of a site. A polygon is the cyclic list of its sides, counter-clockwise: its corner k
/// is where side k - 1 ends and side k starts.
class TriangleClipper {
public:
    TriangleClipper(const LatticeMesh& mesh, const SolidDiagram& diagram) : m_mesh(mesh), m_diagram(diagram) {}

    /// The part of a triangle in a cell; without sides if there is none.
    const std::vector<Side>& clip(std::uint32_t triangle, std::uint32_t cell) {
        m_corners = m_mesh.cornersOf(triangle);
        m_reach = glm::max(glm::abs(m_corners[1] - m_corners[0]), glm::abs(m_corners[2] - m_corners[0]));
        m_site = m_diagram.site(cell);
        m_sides = {{0, 0}, {1, 0}, {2, 0}};
        m_bisectors.clear();
        m_tiedCell = kNone;
        for (const SolidDiagram::Neighbour& neighbour : m_diagram.neighboursOf(cell)) {
            clipBy(neighbour);
            if (m_sides.empty()) break;
        }
        return m_sides;
    }
    /// The neighbour in whose bisector the triangle lies; or kNone.
    std::uint32_t tiedCell() const { return m_tiedCell; }
    const SolidDiagram::Neighbour& neighbour(const Side& side) const { return m_bisectors[side.bisector].neighbour; }

private:
    RankedSite siteOf(const TriangleBisector& bisector) const { return m_diagram.site(bisector.neighbour.site); }

    void clipBy(const SolidDiagram::Neighbour& neighbour) {
        TriangleBisector bisector{neighbour, {}};
        const Vec3 other = m_diagram.site(neighbour.site).point;
        if (isFarFrom(other)) return;
        bool isApart = true, isInBisector = true;
        for (int c = 0; c < 3; ++c) {
            bisector.value[c] = solid_signs::bisectorValue(m_corners[c], m_site.point, other);
            isApart = isApart && bisector.value[c].sign() < 0;
            isInBisector = isInBisector && isTied(bisector.value[c], m_site.point, other);
        }
        if (isInBisector) m_tiedCell = neighbour.site;
        if (isApart) return;  // the whole triangle is on this side
        const std::size_t count = m_sides.size();
        m_isBeyond.resize(count);
        std::size_t beyond = 0;
        for (std::size_t k = 0; k < count; ++k) {
            m_isBeyond[k] = isBeyond(m_sides[(k + count - 1) % count], m_sides[k], bisector);
            beyond += m_isBeyond[k];
        }
        if (beyond == 0) return;
        m_clipped.clear();
        if (beyond < count) {
            for (std::size_t k = 0; k < count; ++k) {
                const bool starts = m_isBeyond[k], ends = m_isBeyond[(k + 1) % count];
                if (!starts || !ends) m_clipped.push_back(m_sides[k]);
                if (!starts && ends) m_clipped.push_back({-1, static_cast<std::uint32_t>(m_bisectors.size())});
            }
            m_bisectors.push_back(bisector);
        }
        m_sides.swap(m_clipped);
    }

    /// Whether the triangle is so far on this side of a bisector that one of its corners shows it.
    bool isFarFrom(Vec3 other) const {
        const BoundedDouble first = solid_signs::bisectorValue(m_corners[0], m_site.point, other);
        const Vec3 growth = 2.0 * glm::abs(other - m_site.point) * m_reach;  // from there to other corners, at most
        const double most = (growth.x + growth.y + growth.z) * (1.0 + 16.0 * kRounding);
        return first.value + 2.0 * first.error + most < 0.0 && !isTied(first, m_site.point, other);
    }

    /// Whether the corner between two sides is beyond a bisector.
    bool isBeyond(const Side& before, const Side& after, const TriangleBisector& by) const {
        if (before.edge >= 0 && after.edge >= 0) return isCornerBeyond(after.edge, by);
        if (before.edge >= 0) return isEdgePointBeyond(before.edge, m_bisectors[after.bisector], by, true);
        if (after.edge >= 0) return isEdgePointBeyond(after.edge, m_bisectors[before.bisector], by, false);
        return isFacePointBeyond(m_bisectors[before.bisector], m_bisectors[after.bisector], by);
    }
    bool isCornerBeyond(int corner, const TriangleBisector& by) const {
        if (const int sign = by.value[corner].sign(); sign != 0) return sign > 0;
        return solid_signs::atPoint(m_corners[corner], m_site, siteOf(by)) > 0;
    }
    /// `leaves`: whether the triangle's edge, along its direction, leaves the cell at the bisector.
    bool isEdgePointBeyond(int edge, const TriangleBisector& at, const TriangleBisector& by, bool leaves) const {
        const int a = edge, b = (edge + 1) % 3;
        int sign = (at.value[a] * by.value[b] - at.value[b] * by.value[a]).sign();
        if (sign == 0) sign = solid_signs::edgeDeterminant(m_corners[a], m_corners[b], m_site, siteOf(at), siteOf(by));
        return leaves ? sign < 0 : sign > 0;
    }
    bool isFacePointBeyond(const TriangleBisector& first, const TriangleBisector& second,
                           const TriangleBisector& by) const {
        const auto &u = first.value, &v = second.value, &w = by.value;
        const BoundedDouble determinant = (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
                                          (u[0] * v[1] - u[1] * v[0]) * w[2];
        int sign = determinant.sign();
        if (sign == 0) {
            sign = solid_signs::triangleDeterminant(m_corners, m_site, siteOf(first), siteOf(second), siteOf(by));
        }
        return sign > 0;
    }

    const LatticeMesh& m_mesh;
    const SolidDiagram& m_diagram;
    std::array<Vec3, 3> m_corners;
    Vec3 m_reach{0.0, 0.0, 0.0};  // of corners from the first, along each axis
    RankedSite m_site;
    std::uint32_t m_tiedCell = kNone;
    std::vector<TriangleBisector> m_bisectors;
    std::vector<Side> m_sides, m_clipped;
    std::vector<std::uint8_t> m_isBeyond;
};

/// The cell behind the facet through which a segment that ends outside a cell leaves it.
std::uint32_t nextCell(const SolidDiagram& diagram, std::uint32_t cell, Vec3 from, Vec3 to) {
    const RankedSite here = diagram.site(cell);
    std::uint32_t next = kNone;
    for (const SolidDiagram::Neighbour& neighbour : diagram.neighboursOf(cell)) {
        const RankedSite site = diagram.site(neighbour.site);
        if (solid_signs::atPoint(to, here, site) < 0) continue;
        // A facet through which the segment leaves where it is already beyond this one is left later.
        if (next == kNone || solid_signs::edgeDeterminant(from, to, here, diagram.site(next), site) < 0) {
            next = neighbour.site;
        }
    }
    return next;
}

/// Pieces of consecutive triangles, whose triangle crossings are numbered from 0.
struct PieceChunk {
    std::vector<TriangleCrossing> crossings;
    std::vector<std::uint32_t> triangle, cell, tiedCell, count;  // count: of corners
    std::vector<std::uint32_t> points, facet;                    // a triangle crossing's number has kIsCrossing

    void reserve(std::size_t pieces) {
        for (auto* perPiece : {&triangle, &cell, &tiedCell, &count}) perPiece->reserve(pieces);
        for (auto* perCorner : {&points, &facet}) perCorner->reserve(4 * pieces);
    }
};
constexpr std::uint32_t kIsCrossing = 0x80000000u;

class SurfaceWalk {
public:
    SurfaceWalk(const LatticeMesh& mesh, const SolidDiagram& diagram, const TaskContext& task)
        : m_mesh(mesh), m_diagram(diagram), m_task(task) {}

    Result<SurfacePieces> walk() {
        for (const auto step : {&SurfaceWalk::locateCorners, &SurfaceWalk::crossEdges, &SurfaceWalk::divideTriangles,
                                &SurfaceWalk::joinChunks}) {
            (this->*step)();
            if (m_task.isCancelled()) return TaskContext::cancelled();
        }
        return std::move(m_result);
    }

private:
    void locateCorners() {
        m_cellOfCorner.resize(m_mesh.corners.size());
        m_isTied.assign(m_mesh.corners.size(), 0);
        forEachIndex(chunksOf(m_mesh.corners.size()), m_task.threads, [&](std::size_t chunk) {
            if (m_task.isCancelled()) return;
            std::uint32_t cell = 0;
            Vec3 anchor(0.0);         // a corner in the cell
            double clearance = -1.0;  // around it, in which all points are in the cell, and none is tied
            const std::size_t end = std::min((chunk + 1) * kChunk, m_mesh.corners.size());
            for (std::size_t c = chunk * kChunk; c < end; ++c) {
                const Vec3 corner = m_mesh.corners[c];
                if (glm::distance(corner, anchor) >= clearance) {
                    cell = m_diagram.cellOf(corner, cell);
                    anchor = corner;
                    clearance = clearanceIn(cell, corner, m_isTied[c]);
                }
                m_cellOfCorner[c] = cell;
            }
        });
    }

    /// A distance around a corner in a cell in which all points are in it, and none is tied: negative if there is none.
    double clearanceIn(std::uint32_t cell, Vec3 corner, std::uint8_t& isCornerTied) const {
        const Vec3 here = m_diagram.site(cell).point;
        double clearance = std::numeric_limits<double>::infinity();
        for (const SolidDiagram::Neighbour& neighbour : m_diagram.neighboursOf(cell)) {
            const Vec3 other = m_diagram.site(neighbour.site).point;
            const BoundedDouble value = solid_signs::bisectorValue(corner, here, other);
            isCornerTied = isCornerTied || isTied(value, here, other);
            // h grows by twice the distance of the sites a step; what is tied is within twice kTieDistance.
            const double distance = -(value.value + 2.0 * value.error) / (2.0 * glm::distance(here, other));
            clearance = std::min(clearance, distance * (1.0 - 64.0 * kRounding) - 4.0 * kTieDistance);
        }
        return clearance;
    }

    void crossEdges() {
        std::vector<std::vector<EdgeCrossing>> crossings(chunksOf(m_mesh.edges.size()));
        m_result.firstCrossing.assign(m_mesh.edges.size() + 1, 0);
        forEachIndex(crossings.size(), m_task.threads, [&](std::size_t chunk) {
            if (m_task.isCancelled()) return;
            const std::size_t end = std::min((chunk + 1) * kChunk, m_mesh.edges.size());
            for (std::size_t e = chunk * kChunk; e < end; ++e) {
                const std::array<std::uint32_t, 2>& edge = m_mesh.edges[e];
                const std::size_t before = crossings[chunk].size();
                for (std::uint32_t cell = m_cellOfCorner[edge[0]]; cell != m_cellOfCorner[edge[1]];) {
                    const std::uint32_t next =
                        nextCell(m_diagram, cell, m_mesh.corners[edge[0]], m_mesh.corners[edge[1]]);
                    crossings[chunk].push_back({cell, next});
                    cell = next;
                }
                m_result.firstCrossing[e + 1] = static_cast<std::uint32_t>(crossings[chunk].size() - before);
            }
        });
        std::partial_sum(m_result.firstCrossing.begin(), m_result.firstCrossing.end(), m_result.firstCrossing.begin());
        for (const std::vector<EdgeCrossing>& chunk : crossings) {
            m_result.edgeCrossings.insert(m_result.edgeCrossings.end(), chunk.begin(), chunk.end());
        }
    }

    void divideTriangles() {
        m_chunks.resize(chunksOf(m_mesh.triangles.size()));
        forEachIndex(m_chunks.size(), m_task.threads, [&](std::size_t chunk) {
            if (m_task.isCancelled()) return;
            TriangleClipper clipper(m_mesh, m_diagram);
            std::vector<std::uint32_t> cells;
            m_chunks[chunk].reserve(kChunk + kChunk / 4);
            const std::size_t end = std::min((chunk + 1) * kChunk, m_mesh.triangles.size());
            for (std::size_t t = chunk * kChunk; t < end && !m_task.isCancelled(); ++t) {
                divideTriangle(static_cast<std::uint32_t>(t), clipper, cells, m_chunks[chunk]);
            }
        });
    }

    void divideTriangle(std::uint32_t t, TriangleClipper& clipper, std::vector<std::uint32_t>& cells,
                        PieceChunk& chunk) const {
        const std::array<std::uint32_t, 3>& corner = m_mesh.triangles[t];
        const std::uint32_t first = m_cellOfCorner[corner[0]];
        if (m_cellOfCorner[corner[1]] == first && m_cellOfCorner[corner[2]] == first) {  // cells are convex
            addPiece(chunk, t, first, wholeTiedCell(t, first), 3);
            chunk.points.insert(chunk.points.end(), corner.begin(), corner.end());
            chunk.facet.insert(chunk.facet.end(), 3, kNone);
            return;
        }
        const std::size_t firstOfTriangle = chunk.crossings.size();
        cells.assign(1, first);
        for (std::size_t next = 0; next < cells.size(); ++next) {
            const std::vector<Side>& sides = clipper.clip(t, cells[next]);
            RUBBLE_ASSERT(sides.size() >= 3);
            addPiece(chunk, t, cells[next], clipper.tiedCell(), static_cast<std::uint32_t>(sides.size()));
            for (std::size_t k = 0; k < sides.size(); ++k) {
                const Side &before = sides[(k + sides.size() - 1) % sides.size()], &after = sides[k];
                chunk.points.push_back(pointAt(t, cells[next], before, after, clipper, firstOfTriangle, chunk));
                chunk.facet.push_back(after.edge >= 0 ? kNone : clipper.neighbour(after).facet);
                if (after.edge >= 0) continue;
                const std::uint32_t behind = clipper.neighbour(after).site;
                if (std::find(cells.begin(), cells.end(), behind) == cells.end()) cells.push_back(behind);
            }
        }
    }

    /// The neighbour in whose bisector a triangle lies that is wholly in a cell.
    std::uint32_t wholeTiedCell(std::uint32_t t, std::uint32_t cell) const {
        const Vec3 here = m_diagram.site(cell).point;
        for (const std::uint32_t corner : m_mesh.triangles[t]) {
            if (!m_isTied[corner]) return kNone;
        }
        for (const SolidDiagram::Neighbour& neighbour : m_diagram.neighboursOf(cell)) {
            const Vec3 other = m_diagram.site(neighbour.site).point;
            if (std::ranges::all_of(m_mesh.cornersOf(t), [&](Vec3 corner) {
                    return isTied(solid_signs::bisectorValue(corner, here, other), here, other);
                })) {
                return neighbour.site;
            }
        }
        return kNone;
    }

    static void addPiece(PieceChunk& chunk, std::uint32_t t, std::uint32_t cell, std::uint32_t tiedCell,
                         std::uint32_t count) {
        chunk.triangle.push_back(t);
        chunk.cell.push_back(cell);
        chunk.tiedCell.push_back(tiedCell);
        chunk.count.push_back(count);
    }

    std::uint32_t pointAt(std::uint32_t t, std::uint32_t cell, const Side& before, const Side& after,
                          const TriangleClipper& clipper, std::size_t firstOfTriangle, PieceChunk& chunk) const {
        if (before.edge >= 0 && after.edge >= 0) return m_mesh.triangles[t][after.edge];
        if (before.edge >= 0) return edgePoint(t, before.edge, cell, clipper.neighbour(after).site);
        if (after.edge >= 0) return edgePoint(t, after.edge, cell, clipper.neighbour(before).site);
        // The bisectors with `before` and `after` turn counter-clockwise, so this Voronoi edge leaves the solid along
        // (s_before - s_cell) × (s_after - s_cell).
        const std::uint32_t j = clipper.neighbour(before).site, k = clipper.neighbour(after).site;
        const std::uint32_t edge = m_diagram.edgeOf(cell, j, k);
        const bool isEven = (cell < j) == ((j < k) == (cell < k));
        for (std::size_t c = firstOfTriangle; c < chunk.crossings.size(); ++c) {
            if (chunk.crossings[c].edge == edge) return static_cast<std::uint32_t>(c) | kIsCrossing;
        }
        chunk.crossings.push_back({edge, t, isEven});
        return (static_cast<std::uint32_t>(chunk.crossings.size()) - 1) | kIsCrossing;
    }

    std::uint32_t edgePoint(std::uint32_t t, int edgeOfTriangle, std::uint32_t cell, std::uint32_t behind) const {
        const std::uint32_t edge = m_mesh.edgesOfTriangle[t][edgeOfTriangle];
        std::uint32_t c = m_result.firstCrossing[edge];
        const auto isBetween = [&](const EdgeCrossing& crossing) {
            return (crossing.from == cell && crossing.to == behind) || (crossing.from == behind && crossing.to == cell);
        };
        while (c < m_result.firstCrossing[edge + 1] && !isBetween(m_result.edgeCrossings[c])) ++c;
        RUBBLE_ASSERT(c < m_result.firstCrossing[edge + 1]);
        return static_cast<std::uint32_t>(m_mesh.corners.size()) + c;
    }

    void joinChunks() {
        struct Place {
            std::size_t crossing, piece, corner;
        };
        std::vector<Place> places(m_chunks.size() + 1, Place{0, 0, 0});
        for (std::size_t k = 0; k < m_chunks.size(); ++k) {
            places[k + 1] = {places[k].crossing + m_chunks[k].crossings.size(),
                             places[k].piece + m_chunks[k].triangle.size(),
                             places[k].corner + m_chunks[k].points.size()};
        }
        const auto [crossings, pieces, corners] = places.back();
        m_result.triangleCrossings.resize(crossings);
        for (auto* perPiece : {&m_result.triangle, &m_result.cell, &m_result.tiedCell}) perPiece->resize(pieces);
        m_result.firstCorner.resize(pieces + 1);
        m_result.firstCorner[pieces] = static_cast<std::uint32_t>(corners);
        for (auto* perCorner : {&m_result.points, &m_result.facet}) perCorner->resize(corners);
        const std::size_t firstFree = m_mesh.corners.size() + m_result.edgeCrossings.size();
        forEachIndex(m_chunks.size(), m_task.threads, [&](std::size_t k) {
            if (m_task.isCancelled()) return;
            const PieceChunk& chunk = m_chunks[k];
            const auto [crossing, piece, corner] = places[k];
            const auto copy = [](const auto& from, auto& to, std::size_t at) {
                std::ranges::copy(from, to.begin() + static_cast<std::ptrdiff_t>(at));
            };
            copy(chunk.crossings, m_result.triangleCrossings, crossing);
            copy(chunk.triangle, m_result.triangle, piece);
            copy(chunk.cell, m_result.cell, piece);
            copy(chunk.tiedCell, m_result.tiedCell, piece);
            copy(chunk.facet, m_result.facet, corner);
            std::exclusive_scan(chunk.count.begin(), chunk.count.end(), m_result.firstCorner.begin() + piece,
                                static_cast<std::uint32_t>(corner));
            const std::uint32_t offset = static_cast<std::uint32_t>(firstFree + crossing);
            std::ranges::transform(chunk.points, m_result.points.begin() + corner, [offset](std::uint32_t point) {
                return point & kIsCrossing ? offset + (point & ~kIsCrossing) : point;
            });
        });
    }

    const LatticeMesh& m_mesh;
    const SolidDiagram& m_diagram;
    const TaskContext& m_task;
    std::vector<std::uint32_t> m_cellOfCorner;
    std::vector<std::uint8_t> m_isTied;  // of each corner: another site is as near, within kTieDistance
    std::vector<PieceChunk> m_chunks;
    SurfacePieces m_result;
};

}  // namespace

void findEdges(LatticeMesh& mesh, const TaskContext& task) {
    struct HalfEdge {
        std::uint32_t high;   // corner
        std::uint32_t place;  // 3 * triangle + side
    };
    const std::size_t parts = groupingParts(task.threads);
    const auto forEachHalf = [&](std::size_t part, const auto& visit) {
        const IndexRange range = chunkRange(mesh.triangles.size(), part, parts);
        for (std::size_t t = range.begin; t < range.end && !task.isCancelled(); ++t) {
            for (std::uint32_t k = 0; k < 3; ++k) {
                const auto [low, high] = std::minmax(mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]);
                visit(low, HalfEdge{high, 3 * static_cast<std::uint32_t>(t) + k});
            }
        }
    };
    Groups<HalfEdge> atLow = grouped<HalfEdge>(mesh.corners.size(), parts, task.threads, forEachHalf);
    if (task.isCancelled()) return;
    const std::size_t chunks = chunksOf(mesh.corners.size());
    const auto forEachLow = [&](std::size_t chunk, const auto& visit) {
        if (task.isCancelled()) return;
        const std::size_t end = std::min((chunk + 1) * kChunk, mesh.corners.size());
        for (std::size_t low = chunk * kChunk; low < end; ++low) visit(static_cast<std::uint32_t>(low), atLow.of(low));
    };
    std::vector<std::uint32_t> firstEdge(chunks + 1, 0);
    forEachIndex(chunks, task.threads, [&](std::size_t chunk) {
        forEachLow(chunk, [&](std::uint32_t, std::span<HalfEdge> halves) {
            std::ranges::sort(halves, {}, &HalfEdge::high);
            for (std::size_t k = 0; k < halves.size(); ++k) {
                firstEdge[chunk + 1] += k == 0 || halves[k].high != halves[k - 1].high;
            }
        });
    });
    if (task.isCancelled()) return;
    std::partial_sum(firstEdge.begin(), firstEdge.end(), firstEdge.begin());
    mesh.edges.resize(firstEdge.back());
    mesh.edgesOfTriangle.resize(mesh.triangles.size());
    forEachIndex(chunks, task.threads, [&](std::size_t chunk) {
        std::uint32_t next = firstEdge[chunk];
        forEachLow(chunk, [&](std::uint32_t low, std::span<const HalfEdge> halves) {
            for (std::size_t k = 0; k < halves.size(); ++k) {
                if (k == 0 || halves[k].high != halves[k - 1].high) mesh.edges[next++] = {low, halves[k].high};
                mesh.edgesOfTriangle[halves[k].place / 3][halves[k].place % 3] = next - 1;
            }
        });
    });
}

std::vector<std::uint32_t> supportOf(const LatticeMesh& mesh, const SurfacePieces& pieces, std::uint32_t point) {
    const std::uint32_t corners = static_cast<std::uint32_t>(mesh.corners.size());
    if (point < corners) return {point};
    if (point < corners + pieces.edgeCrossings.size()) {
        const auto above = std::ranges::upper_bound(pieces.firstCrossing, point - corners);
        const auto& ends = mesh.edges[static_cast<std::size_t>(above - pieces.firstCrossing.begin()) - 1];
        return {ends[0], ends[1]};
    }
    const std::size_t crossing = point - corners - pieces.edgeCrossings.size();
    if (crossing >= pieces.triangleCrossings.size()) return {};
    const auto& triangle = mesh.triangles[pieces.triangleCrossings[crossing].triangle];
    return {triangle.begin(), triangle.end()};
}

Result<SurfacePieces> walkSurface(const LatticeMesh& mesh, const SolidDiagram& diagram, const TaskContext& task) {
    return SurfaceWalk(mesh, diagram, task).walk();
}

}  // namespace rubble
