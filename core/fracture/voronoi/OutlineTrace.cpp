#include "core/fracture/voronoi/OutlineTrace.h"

#include "core/base/Assert.h"

#include <cmath>

namespace rubble {
namespace {

bool hasTooManyCrossings(const OutlineTrace& trace) { return trace.crossings.size() > kMaxOutlineCrossings; }

/// Traces one ring after the other. Going counter-clockwise around a cell, a line that leaves it has the corner before
/// on its right and the corner after on its left.
class Tracer {
public:
    Tracer(const Delaunay& delaunay, const std::vector<std::uint32_t>& outgoing, OutlineTrace& trace)
        : m_delaunay(delaunay), m_diagram(delaunay), m_outgoing(outgoing), m_trace(trace) {
        trace.firstArc.assign(delaunay.sites.size(), kNone);
        // A little more than the number of evenly spread cells that the outline of a square enters.
        const auto expected = static_cast<std::size_t>(6.0 * std::sqrt(static_cast<double>(delaunay.sites.size())));
        trace.crossings.reserve(expected);
        trace.arcs.reserve(expected);
    }

    void traceRing(std::uint32_t ring) {
        const std::uint32_t begin = m_trace.ringStarts[ring], end = m_trace.ringStarts[ring + 1];
        const std::size_t firstCrossing = m_trace.crossings.size();
        m_cell = cellOf(m_trace.vertices[begin]);
        const std::uint32_t firstCell = m_cell;
        for (std::uint32_t edge = begin; edge < end; ++edge) followEdge(edge, edge + 1 < end ? edge + 1 : begin);
        if (hasTooManyCrossings(m_trace)) return;
        RUBBLE_ASSERT(m_cell == firstCell);
        addArcs(ring, firstCrossing);
    }

private:
    /// The cell that contains the point: walks from the current cell to nearer and nearer sites.
    std::uint32_t cellOf(Vec2 point) const {
        std::uint32_t cell = m_cell;
        for (bool moved = true; moved;) {
            moved = false;
            const std::uint32_t first = m_outgoing[cell];
            std::uint32_t spoke = first;
            do {
                const std::uint32_t neighbour = targetOf(m_delaunay, spoke);
                if (neighbour != kGhost && m_diagram.isNearer(point, neighbour, cell)) {
                    cell = neighbour;
                    moved = true;
                    break;
                }
                spoke = nextAround(m_delaunay, spoke);
            } while (spoke != first);
        }
        return cell;
    }

    void followEdge(std::uint32_t edge, std::uint32_t edgeEnd) {
        const DirectedLine line = {m_trace.vertices[edge], m_trace.vertices[edgeEnd]};
        std::uint32_t exit = firstExit(line);
        for (;;) {
            const std::uint32_t neighbour = exit == kNone ? kGhost : targetOf(m_delaunay, exit);
            if (hasTooManyCrossings(m_trace)) return;
            if (neighbour == kGhost || !m_diagram.isNearer(line.to, neighbour, m_cell)) return;
            m_trace.crossings.push_back({exit, edge, edgeEnd});
            m_cell = neighbour;
            exit = exitAfter(m_delaunay.twin(exit), line);
        }
    }

    /// The half-edge from the cell's site through whose Voronoi edge the line leaves the cell; kNone if the infinite
    /// line does not pass through the cell (it starts at a corner and touches no more than that).
    std::uint32_t firstExit(const DirectedLine& line) const {
        const std::uint32_t first = m_outgoing[m_cell];
        std::uint32_t spoke = first;
        int before = m_diagram.sideOfCorner(line, Delaunay::triangleOf(m_delaunay.twin(spoke)));
        do {
            const int after = m_diagram.sideOfCorner(line, Delaunay::triangleOf(spoke));
            if (before < 0 && after > 0) return spoke;
            before = after;
            spoke = nextAround(m_delaunay, spoke);
        } while (spoke != first);
        return kNone;
    }

    /// The same for a line that has entered through the Voronoi edge of `entry`.
    std::uint32_t exitAfter(std::uint32_t entry, const DirectedLine& line) const {
        std::uint32_t spoke = nextAround(m_delaunay, entry);
        while (spoke != entry && m_diagram.sideOfCorner(line, Delaunay::triangleOf(spoke)) < 0) {
            spoke = nextAround(m_delaunay, spoke);
        }
        return spoke == entry ? kNone : spoke;
    }

    void addArcs(std::uint32_t ring, std::size_t firstCrossing) {
        const std::uint32_t begin = m_trace.ringStarts[ring], size = m_trace.ringStarts[ring + 1] - begin;
        const std::uint32_t first = static_cast<std::uint32_t>(firstCrossing);
        const std::uint32_t end = static_cast<std::uint32_t>(m_trace.crossings.size());
        if (first == end) addArc({m_cell, kNone, kNone, ring, begin, size, kNone});
        for (std::uint32_t crossing = first; crossing < end; ++crossing) {
            const bool isLast = crossing + 1 == end;
            const std::uint32_t leave = isLast ? first : crossing + 1;
            const std::uint32_t enterEdge = m_trace.crossings[crossing].edge, leaveEdge = m_trace.crossings[leave].edge;
            const std::uint32_t count = leaveEdge - enterEdge + (isLast ? size : 0);
            const std::uint32_t vertex = enterEdge + 1 == begin + size ? begin : enterEdge + 1;
            addArc({targetOf(m_delaunay, m_trace.crossings[crossing].halfEdge), crossing, leave, ring, vertex, count,
                    kNone});
        }
    }

    void addArc(BoundaryArc arc) {
        std::uint32_t& first = m_trace.firstArc[arc.cell];
        arc.nextInCell = first;
        first = static_cast<std::uint32_t>(m_trace.arcs.size());
        m_trace.arcs.push_back(arc);
    }

    const Delaunay& m_delaunay;
    PerturbedDiagram m_diagram;
    const std::vector<std::uint32_t>& m_outgoing;
    OutlineTrace& m_trace;
    std::uint32_t m_cell = 0;
};

}  // namespace

Result<OutlineTrace> traceOutline(const Polygon& outline, const Delaunay& delaunay,
                                  const std::vector<std::uint32_t>& outgoing) {
    OutlineTrace trace;
    trace.vertices = outline.outer;
    trace.ringStarts = {0, static_cast<std::uint32_t>(outline.outer.size())};
    for (const Ring& hole : outline.holes) {
        trace.vertices.insert(trace.vertices.end(), hole.begin(), hole.end());
        trace.ringStarts.push_back(static_cast<std::uint32_t>(trace.vertices.size()));
    }
    const std::size_t likely = 4 * trace.vertices.size();  // for small patterns; large ones reallocate
    trace.crossings.reserve(likely);
    trace.arcs.reserve(likely);
    Tracer tracer(delaunay, outgoing, trace);
    for (std::uint32_t ring = 0; ring + 1 < trace.ringStarts.size(); ++ring) tracer.traceRing(ring);
    if (hasTooManyCrossings(trace)) {
        return Error{ErrorCode::Limit, "The outline crosses cells of the pattern in more than " +
                                           std::to_string(kMaxOutlineCrossings) +
                                           " places. Use fewer seeds or a simpler outline."};
    }
    return trace;
}

}  // namespace rubble
