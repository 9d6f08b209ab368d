#include "core/fracture/voronoi/CellAssembly.h"

namespace rubble {
namespace {

/// Where a cell lies that the outline does not enter. The values are bits, so that those of all neighbours can be
/// combined.
enum CellLocation : std::uint8_t { kUnknown = 0, kInside = 1, kOutside = 2 };

class Assembler {
public:
    Assembler(const CellSources& sources, std::uint32_t firstSite, std::uint32_t endSite)
        : m_sources(sources),
          m_delaunay(sources.delaunay),
          m_firstSite(firstSite),
          m_places(endSite - firstSite, kUnknown),
          m_clipper(sources.delaunay, sources.outgoing, sources.trace, sources.numbers, sources.points) {
        m_cells.firstSite = firstSite;
        m_cells.firstPieces.reserve(m_places.size() + 1);
        m_cells.pieces.corners.reserve(7 * m_places.size());
        m_cells.pieces.ringEnds.reserve(m_places.size() + 1);
        m_cells.pieces.pieceEnds.reserve(m_places.size() + 1);
    }

    CellRange run() && {
        for (std::uint32_t i = 0; i < m_places.size(); ++i) {
            const std::uint32_t site = m_firstSite + i;
            m_cells.firstPieces.push_back(pieceCount());
            if (m_sources.trace.firstArc[site] == kNone) {
                addUncrossedCell(site);
            } else {
                m_clipper.clip(site, m_clipped);
                addPieces();
                noteTouchingVertices(site);
            }
        }
        m_cells.firstPieces.push_back(pieceCount());
        return std::move(m_cells);
    }

private:
    std::uint32_t pieceCount() const { return static_cast<std::uint32_t>(m_cells.pieces.pieceEnds.size()); }

    /// Appends the whole cell, and removes it again if it lies outside. It lies where a neighbour that the outline does
    /// not enter lies; without such a neighbour, where its site lies.
    void addUncrossedCell(std::uint32_t site) {
        std::vector<CellCorner>& corners = m_cells.pieces.corners;
        const std::size_t begin = corners.size();
        const std::uint32_t first = m_sources.outgoing[site];
        std::uint32_t spoke = first, place = kUnknown;
        std::uint32_t before = Delaunay::triangleOf(m_delaunay.twin(first));
        do {
            const Delaunay::Triangle& triangle = m_delaunay.triangles[spoke >> 2];
            const std::uint32_t back = Delaunay::previous(spoke) & 3;
            const std::uint32_t neighbour = triangle.corner[back];
            corners.push_back({spoke >> 2, neighbour});
            noteIfCoincident(before, spoke >> 2);
            before = spoke >> 2;
            if (neighbour - m_firstSite < m_places.size()) place |= m_places[neighbour - m_firstSite];
            spoke = triangle.twin[back];
        } while (spoke != first);
        if (place == kUnknown) place = placeOfSite(site);
        m_places[site - m_firstSite] = static_cast<std::uint8_t>(place);
        if (place == kInside) {
            endRing();
            endPiece();
        } else {
            corners.resize(begin);
        }
    }

    std::uint32_t placeOfSite(std::uint32_t site) const {
        const bool isOutside = containment(m_sources.outline, m_delaunay.sites[site]) == Containment::Outside;
        return isOutside ? kOutside : kInside;
    }

    void addPieces() {
        std::uint32_t corner = 0, ring = 0;
        for (const std::uint32_t pieceEnd : m_clipped.pieceEnds) {
            for (; ring < pieceEnd; ++ring) {
                const std::uint32_t begin = corner;
                for (; corner < m_clipped.ringEnds[ring]; ++corner) {
                    m_cells.pieces.corners.push_back(m_clipped.corners[corner]);
                    const std::uint32_t next = corner + 1 < m_clipped.ringEnds[ring] ? corner + 1 : begin;
                    noteIfCoincident(m_clipped.corners[corner].point, m_clipped.corners[next].point);
                }
                if (!m_sources.acuteCorners.isEmpty())
                    noteAcuteCorners(std::span(m_clipped.corners).subspan(begin, corner - begin));
                endRing();
            }
            endPiece();
        }
    }

    /// Notes the points in acute corner regions as coincident with the vertex: for each corner on an edge of the
    /// outline, itself and the two beside it, in the regions at the ends of that edge.
    void noteAcuteCorners(std::span<const CellCorner> ring) {
        const PointNumbers& numbers = m_sources.numbers;
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const std::uint32_t point = ring[i].point;
            if (point < numbers.vertices) continue;
            std::uint32_t first = point - numbers.vertices, second = first;
            if (point >= numbers.crossings) {
                const OutlineCrossing& crossing = m_sources.trace.crossings[point - numbers.crossings];
                first = crossing.edge, second = crossing.edgeEnd;
            }
            const std::size_t before = i > 0 ? i - 1 : ring.size() - 1, after = i + 1 < ring.size() ? i + 1 : 0;
            const bool isFirstAcute = m_sources.acuteCorners.isAcute(first),
                       isSecondAcute = m_sources.acuteCorners.isAcute(second);
            if (!isFirstAcute && !isSecondAcute) continue;
            for (const std::size_t k : {before, i, after}) {
                if (isFirstAcute) noteIfInAcuteCorner(first, ring[k].point);
                if (isSecondAcute) noteIfInAcuteCorner(second, ring[k].point);
            }
        }
    }

    void noteIfInAcuteCorner(std::uint32_t vertex, std::uint32_t point) {
        const std::uint32_t tip = m_sources.numbers.vertices + vertex;
        if (point != tip && m_sources.acuteCorners.contain(vertex, m_sources.points[point]))
            m_cells.coincident.push_back({tip, point});
    }

    void endRing() { m_cells.pieces.ringEnds.push_back(static_cast<std::uint32_t>(m_cells.pieces.corners.size())); }
    void endPiece() { m_cells.pieces.pieceEnds.push_back(static_cast<std::uint32_t>(m_cells.pieces.ringEnds.size())); }

    void noteIfCoincident(std::uint32_t a, std::uint32_t b) {
        if (m_sources.frame.coincide(m_sources.points[a], m_sources.points[b])) m_cells.coincident.push_back({a, b});
    }

    /// Notes the outline vertices that lie on a bisector of their cell, within the weld distance.
    void noteTouchingVertices(std::uint32_t site) {
        const OutlineTrace& trace = m_sources.trace;
        const std::uint32_t firstPiece = m_cells.firstPieces.back();
        if (firstPiece == pieceCount()) return;
        for (std::uint32_t p = trace.firstArc[site]; p != kNone; p = trace.arcs[p].nextInCell) {
            const BoundaryArc& arc = trace.arcs[p];
            const std::uint32_t begin = trace.ringStarts[arc.ring], end = trace.ringStarts[arc.ring + 1];
            for (std::uint32_t i = 0, vertex = arc.firstVertex; i < arc.vertexCount; ++i) {
                if (isOnBisector(site, trace.vertices[vertex])) {
                    m_cells.touches.push_back({m_sources.numbers.vertices + vertex, firstPiece, pieceCount() - 1});
                }
                vertex = vertex + 1 == end ? begin : vertex + 1;
            }
        }
    }

    bool isOnBisector(std::uint32_t site, Vec2 point) const {
        const Vec2 toSite = m_delaunay.sites[site] - point;
        const std::uint32_t first = m_sources.outgoing[site];
        std::uint32_t spoke = first;
        do {
            const std::uint32_t neighbour = targetOf(m_delaunay, spoke);
            spoke = nextAround(m_delaunay, spoke);
            if (neighbour == kGhost) continue;
            const Vec2 toNeighbour = m_delaunay.sites[neighbour] - point, apart = toNeighbour - toSite;
            // The distance to the bisector times twice the distance of the sites.
            const double product = apart.x * (toSite.x + toNeighbour.x) + apart.y * (toSite.y + toNeighbour.y);
            const double limit = 2.0 * m_sources.frame.weldDistance;
            if (product * product <= limit * limit * (apart.x * apart.x + apart.y * apart.y)) return true;
        } while (spoke != first);
        return false;
    }

    const CellSources& m_sources;
    const Delaunay& m_delaunay;
    std::uint32_t m_firstSite;
    std::vector<std::uint8_t> m_places;  // of the range's sites that the outline does not enter
    CellClipper m_clipper;
    CellPieces m_clipped;
    CellRange m_cells;
};

}  // namespace

CellRange assembleCells(const CellSources& sources, std::uint32_t firstSite, std::uint32_t endSite) {
    return Assembler(sources, firstSite, endSite).run();
}

}  // namespace rubble
