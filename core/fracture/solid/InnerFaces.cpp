#include "core/fracture/solid/InnerFaces.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>

namespace rubble {
namespace {

/// A part of a Voronoi edge inside the solid, along its direction.
struct InsideInterval {
    std::uint32_t edge = 0;
    std::uint32_t from = 0, to = 0;  // points
};

class InnerFaceBuilder {
public:
    InnerFaceBuilder(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces)
        : m_mesh(mesh),
          m_diagram(diagram),
          m_pieces(pieces),
          m_firstCrossing(static_cast<std::uint32_t>(mesh.corners.size() + pieces.edgeCrossings.size())),
          m_firstVoronoiCorner(surfacePointCount(mesh, pieces)) {}

    Result<InnerFaces> build() {
        sortCrossings();
        findInside();
        if (!findIntervals()) {
            return Error{ErrorCode::Degenerate, "The surface does not bound a solid: it crosses itself."};
        }
        gatherEdges();
        return std::move(m_result);
    }

private:
    /// Groups the triangle crossings by Voronoi edge, in the order of pieces.
    void sortCrossings() {
        m_begin.assign(m_diagram.edges().size() + 1, 0);
        for (const TriangleCrossing& crossing : m_pieces.triangleCrossings) ++m_begin[crossing.edge + 1];
        std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
        m_crossings.resize(m_pieces.triangleCrossings.size());
        std::vector<std::uint32_t> next(m_begin.begin(), m_begin.end() - 1);
        for (std::uint32_t c = 0; c < m_crossings.size(); ++c) {
            m_crossings[next[m_pieces.triangleCrossings[c].edge]++] = c;
        }
    }

    /// Which Voronoi corners are inside: far ones are not, and each crossing on the way from one to another changes it.
    void findInside() {
        const std::vector<Tetrahedralization::Tetrahedron>& tetrahedra = m_diagram.sites().tetrahedra;
        m_isInside.assign(tetrahedra.size(), 0);
        std::vector<std::uint8_t> isKnown(tetrahedra.size(), 0);
        std::vector<std::uint32_t> firstEdge(tetrahedra.size() + 1, 0), edges(2 * m_diagram.edges().size());
        for (const SolidDiagram::Edge& edge : m_diagram.edges()) ++firstEdge[edge.from + 1], ++firstEdge[edge.to + 1];
        std::partial_sum(firstEdge.begin(), firstEdge.end(), firstEdge.begin());
        std::vector<std::uint32_t> next(firstEdge.begin(), firstEdge.end() - 1);
        for (std::uint32_t e = 0; e < m_diagram.edges().size(); ++e) {
            const SolidDiagram::Edge& edge = m_diagram.edges()[e];
            edges[next[edge.from]++] = e, edges[next[edge.to]++] = e;
        }
        std::vector<std::uint32_t> queue;
        for (std::uint32_t t = 0; t < tetrahedra.size(); ++t) {
            if (m_diagram.isFar(t)) isKnown[t] = 1, queue.push_back(t);
        }
        for (std::size_t k = 0; k < queue.size(); ++k) {
            const std::uint32_t t = queue[k];
            for (std::uint32_t place = firstEdge[t]; place < firstEdge[t + 1]; ++place) {
                const SolidDiagram::Edge& edge = m_diagram.edges()[edges[place]];
                const std::uint32_t other = edge.from == t ? edge.to : edge.from;
                if (isKnown[other]) continue;
                const std::uint32_t crossings = m_begin[edges[place] + 1] - m_begin[edges[place]];
                m_isInside[other] = m_isInside[t] ^ (crossings & 1);
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
        const std::span crossings = std::span(m_crossings).subspan(m_begin[edge], m_begin[edge + 1] - m_begin[edge]);
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

    bool findIntervals() {
        for (std::uint32_t e = 0; e < m_diagram.edges().size(); ++e) {
            const SolidDiagram::Edge& edge = m_diagram.edges()[e];
            if (m_begin[e] == m_begin[e + 1] && !m_isInside[edge.from]) continue;
            if (!sortAlong(e)) return false;
            std::uint32_t start = m_firstVoronoiCorner + edge.from;
            for (std::uint32_t k = m_begin[e]; k < m_begin[e + 1]; ++k) {
                const std::uint32_t point = m_firstCrossing + m_crossings[k];
                if (isLeaving(m_crossings[k])) m_intervals.push_back({e, start, point});
                start = point;
            }
            if (m_isInside[edge.to]) m_intervals.push_back({e, start, m_firstVoronoiCorner + edge.to});
        }
        return true;
    }

    /// Calls visit(facet, edge) for every edge of a facet.
    template <class Visit>
    void forEachEdge(const Visit& visit) const {
        for (std::uint32_t piece = 0; piece < m_pieces.pieceCount(); ++piece) {
            const std::uint32_t first = m_pieces.firstCorner[piece], end = m_pieces.firstCorner[piece + 1];
            const std::uint32_t cell = m_pieces.cell[piece];
            for (std::uint32_t c = first; c < end; ++c) {
                const std::uint32_t behind = m_pieces.behind[c];
                if (behind == kNone || behind < cell) continue;
                const std::uint32_t from = m_pieces.points[c], to = m_pieces.points[c + 1 < end ? c + 1 : first];
                visit(m_diagram.facetOf(cell, behind),
                      PointStep{to, from});  // against the edge of the lower cell's piece
            }
        }
        for (const InsideInterval& interval : m_intervals) {
            const std::array<std::uint32_t, 3>& site = m_diagram.edges()[interval.edge].site;
            visit(m_diagram.facetOf(site[0], site[1]), PointStep{interval.from, interval.to});
            visit(m_diagram.facetOf(site[1], site[2]), PointStep{interval.from, interval.to});
            visit(m_diagram.facetOf(site[0], site[2]), PointStep{interval.to, interval.from});
        }
    }

    void gatherEdges() {
        m_result.firstEdge.assign(m_diagram.facets().size() + 1, 0);
        forEachEdge([&](std::uint32_t facet, const PointStep&) { ++m_result.firstEdge[facet + 1]; });
        std::partial_sum(m_result.firstEdge.begin(), m_result.firstEdge.end(), m_result.firstEdge.begin());
        m_result.edges.resize(m_result.firstEdge.back());
        std::vector<std::uint32_t> next(m_result.firstEdge.begin(), m_result.firstEdge.end() - 1);
        forEachEdge([&](std::uint32_t facet, const PointStep& edge) { m_result.edges[next[facet]++] = edge; });
    }

    const LatticeMesh& m_mesh;
    const SolidDiagram& m_diagram;
    const SurfacePieces& m_pieces;
    std::uint32_t m_firstCrossing, m_firstVoronoiCorner;
    std::vector<std::uint32_t> m_begin, m_crossings;  // triangle crossings, by edge
    std::vector<std::uint8_t> m_isInside;             // of each tetrahedron's Voronoi corner
    std::vector<InsideInterval> m_intervals;
    InnerFaces m_result;
};

}  // namespace

std::uint32_t surfacePointCount(const LatticeMesh& mesh, const SurfacePieces& pieces) {
    return static_cast<std::uint32_t>(mesh.corners.size() + pieces.edgeCrossings.size() +
                                      pieces.triangleCrossings.size());
}

Result<InnerFaces> innerFaces(const LatticeMesh& mesh, const SolidDiagram& diagram, const SurfacePieces& pieces) {
    return InnerFaceBuilder(mesh, diagram, pieces).build();
}

}  // namespace rubble
