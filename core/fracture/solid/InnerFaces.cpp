#include "core/fracture/solid/InnerFaces.h"

#include "core/base/Assert.h"
#include "core/base/Parallel.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

namespace rubble {
namespace {

/// A part of a Voronoi edge inside the solid, along its direction.
struct InsideInterval {
    std::array<std::uint32_t, 3> facets{};  // of its sites i, j, k: between i and j, j and k, i and k
    std::uint32_t from = 0, to = 0;         // points
};

class InnerFaceBuilder {
public:
    InnerFaceBuilder(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                     const TaskContext& task)
        : m_mesh(mesh),
          m_diagram(diagram),
          m_pieces(pieces),
          m_task(task),
          m_firstCrossing(static_cast<std::uint32_t>(mesh.corners.size() + pieces.edgeCrossings.size())),
          m_firstVoronoiCorner(surfacePointCount(mesh, pieces)) {}

    Result<InnerFaces> build() {
        sortCrossings();
        findInside();
        if (!findIntervals()) {
            return Error{ErrorCode::Degenerate, "The surface does not bound a solid: it crosses itself."};
        }
        gatherEdges();
        if (m_task.isCancelled()) return TaskContext::cancelled();
        return std::move(m_result);
    }

private:
    /// Groups the triangle crossings by Voronoi edge, in the order of pieces.
    void sortCrossings() {
        m_crossings = grouped<std::uint32_t>(m_diagram.edges().size(), [&](const auto& visit) {
            for (std::uint32_t c = 0; c < m_pieces.triangleCrossings.size(); ++c) {
                visit(m_pieces.triangleCrossings[c].edge, c);
            }
        });
    }

    /// Which Voronoi corners are inside: far ones are not, and each crossing on the way from one to another changes it.
    void findInside() {
        const std::vector<Tetrahedralization::Tetrahedron>& tetrahedra = m_diagram.sites().tetrahedra;
        m_isInside.assign(tetrahedra.size(), 0);
        std::vector<std::uint8_t> isKnown(tetrahedra.size(), 0);
        const Groups<std::uint32_t> edges = grouped<std::uint32_t>(tetrahedra.size(), [&](const auto& visit) {
            for (std::uint32_t e = 0; e < m_diagram.edges().size() && !m_task.isCancelled(); ++e) {
                const SolidDiagram::Edge& edge = m_diagram.edges()[e];
                visit(edge.from, e), visit(edge.to, e);
            }
        });
        std::vector<std::uint32_t> queue;
        for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
            if (m_diagram.isFar(t)) isKnown[t] = 1, queue.push_back(t);
        }
        for (std::size_t k = 0; k < queue.size() && !m_task.isCancelled(); ++k) {
            const std::uint32_t t = queue[k];
            for (const std::uint32_t e : edges.of(t)) {
                const SolidDiagram::Edge& edge = m_diagram.edges()[e];
                const std::uint32_t other = edge.from == t ? edge.to : edge.from;
                if (isKnown[other]) continue;
                m_isInside[other] = m_isInside[t] ^ (m_crossings.of(e).size() & 1);
                isKnown[other] = 1;
                queue.push_back(other);
            }
        }
    }

    bool isLeaving(std::uint32_t crossing) const { return m_pieces.triangleCrossings[crossing].isLeaving; }

    int order(std::uint32_t a, std::uint32_t b) const {
        const TriangleCrossing &first = m_pieces.triangleCrossings[a], &second = m_pieces.triangleCrossings[b];
        const std::array<std::uint32_t, 3>& site = m_diagram.edges()[first.edge].site;
        return solid_signs::orderAlongEdge(m_mesh.cornersOf(first.triangle), first.isLeaving,
                                           m_mesh.cornersOf(second.triangle), second.isLeaving, m_diagram.site(site[0]),
                                           m_diagram.site(site[1]), m_diagram.site(site[2]));
    }

    /// Sorts the crossings of an edge along it; false if it would not leave and enter the solid in turn. Where it
    /// leaves and enters it at one place, as where the surface touches itself, the one comes first that fits.
    bool sortAlong(std::uint32_t edge) {
        const std::span<std::uint32_t> crossings = m_crossings.of(edge);
        if (crossings.size() > 2) {
            std::stable_sort(crossings.begin(), crossings.end(),
                             [this](std::uint32_t a, std::uint32_t b) { return order(a, b) < 0; });
        }
        bool isInside = m_isInside[m_diagram.edges()[edge].from];
        for (std::size_t k = 0; k < crossings.size(); ++k, isInside = !isInside) {
            std::size_t fits = k;
            while (fits < crossings.size() && isLeaving(crossings[fits]) != isInside) ++fits;
            if (fits == crossings.size()) return false;
            if (crossings.size() > 2 && fits > k && order(crossings[k], crossings[fits]) != 0) return false;
            std::rotate(crossings.begin() + k, crossings.begin() + fits, crossings.begin() + fits + 1);
        }
        return isInside == (m_isInside[m_diagram.edges()[edge].to] != 0);
    }

    /// False if the crossings of an edge do not leave and enter the solid in turn.
    bool findIntervals() {
        constexpr std::size_t kChunk = 1024;  // edges
        const std::size_t count = m_diagram.edges().size();
        std::vector<std::vector<InsideInterval>> intervals((count + kChunk - 1) / kChunk);
        std::vector<std::uint8_t> isInTurn(intervals.size(), 1);
        forEachIndex(intervals.size(), m_task.threads, [&](std::size_t chunk) {
            const std::size_t end = std::min((chunk + 1) * kChunk, count);
            for (std::size_t e = chunk * kChunk; e < end && !m_task.isCancelled(); ++e) {
                if (!addIntervals(static_cast<std::uint32_t>(e), intervals[chunk])) isInTurn[chunk] = 0;
            }
        });
        for (const std::vector<InsideInterval>& chunk : intervals) {
            m_intervals.insert(m_intervals.end(), chunk.begin(), chunk.end());
        }
        return std::ranges::find(isInTurn, 0) == isInTurn.end();
    }

    bool addIntervals(std::uint32_t e, std::vector<InsideInterval>& intervals) {
        const SolidDiagram::Edge& edge = m_diagram.edges()[e];
        if (m_crossings.of(e).empty() && !m_isInside[edge.from]) return true;
        if (!sortAlong(e)) return false;
        const auto& [i, j, k] = edge.site;
        const std::array<std::uint32_t, 3> facets = {m_diagram.facetOf(i, j), m_diagram.facetOf(j, k),
                                                     m_diagram.facetOf(i, k)};
        std::uint32_t start = m_firstVoronoiCorner + edge.from;
        for (const std::uint32_t crossing : m_crossings.of(e)) {
            const std::uint32_t point = m_firstCrossing + crossing;
            if (isLeaving(crossing)) intervals.push_back({facets, start, point});
            start = point;
        }
        if (m_isInside[edge.to]) intervals.push_back({facets, start, m_firstVoronoiCorner + edge.to});
        return true;
    }

    /// Calls visit(facet, edge) for the edges of facets on some pieces.
    template <class Visit>
    void forEachPieceEdge(IndexRange pieces, const Visit& visit) const {
        for (std::size_t piece = pieces.begin; piece < pieces.end && !m_task.isCancelled(); ++piece) {
            const std::uint32_t first = m_pieces.firstCorner[piece], end = m_pieces.firstCorner[piece + 1];
            for (std::uint32_t c = first; c < end; ++c) {
                const std::uint32_t facet = m_pieces.facet[c];
                if (facet == kNone || m_diagram.facets()[facet][0] != m_pieces.cell[piece]) continue;
                const std::uint32_t from = m_pieces.points[c], to = m_pieces.points[c + 1 < end ? c + 1 : first];
                visit(facet, PointStep{to, from});  // against the edge of the lower cell's piece
            }
        }
    }
    /// And for those on Voronoi edges.
    template <class Visit>
    void forEachIntervalEdge(const Visit& visit) const {
        for (const InsideInterval& interval : m_intervals) {
            const auto& [ij, jk, ik] = interval.facets;
            visit(ij, PointStep{interval.from, interval.to});
            visit(jk, PointStep{interval.from, interval.to});
            visit(ik, PointStep{interval.to, interval.from});
        }
    }

    void gatherEdges() {
        const std::size_t parts = groupingParts(m_task.threads);  // of the pieces; one more: intervals
        const auto forEachEdge = [&](std::size_t part, const auto& visit) {
            if (part == parts) return forEachIntervalEdge(visit);
            forEachPieceEdge(chunkRange(m_pieces.pieceCount(), part, parts), visit);
        };
        m_result.edges = grouped<PointStep>(m_diagram.facets().size(), parts + 1, m_task.threads, forEachEdge);
    }

    const LatticeMesh& m_mesh;
    const SolidDiagram& m_diagram;
    const SurfacePieces& m_pieces;
    const TaskContext& m_task;
    std::uint32_t m_firstCrossing, m_firstVoronoiCorner;
    Groups<std::uint32_t> m_crossings;     // triangle crossings, by edge
    std::vector<std::uint8_t> m_isInside;  // of each tetrahedron's Voronoi corner
    std::vector<InsideInterval> m_intervals;
    InnerFaces m_result;
};

}  // namespace

std::uint32_t surfacePointCount(const LatticeMesh& mesh, const SurfacePieces& pieces) {
    return static_cast<std::uint32_t>(mesh.corners.size() + pieces.edgeCrossings.size() +
                                      pieces.triangleCrossings.size());
}

Result<InnerFaces> innerFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces,
                              const TaskContext& task) {
    return InnerFaceBuilder(mesh, diagram, pieces, task).build();
}

}  // namespace rubble
