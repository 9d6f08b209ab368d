#include "core/fracture/voronoi/CellClipper.h"

#include "core/base/Assert.h"
#include "core/geometry/polygon/IndexedCorners.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr std::size_t kReserved = 16;  // more crossings than most cells have

std::span<const CellCorner> ringOf(const CellPieces& pieces, std::size_t ring) {
    const std::size_t begin = ring == 0 ? 0 : pieces.ringEnds[ring - 1];
    return std::span(pieces.corners).subspan(begin, pieces.ringEnds[ring] - begin);
}

Ring pointsOf(std::span<const CellCorner> corners, std::span<const Vec2> points) {
    Ring ring;
    ring.reserve(corners.size());
    for (const CellCorner& corner : corners) ring.push_back(points[corner.point]);
    return ring;
}

/// Sorts pieces, of one ring each, by their smallest corners.
void sortPieces(CellPieces& pieces, std::span<const Vec2> points) {
    struct Entry {
        Vec2 smallest;
        std::size_t ring;
    };
    std::vector<Entry> entries;
    for (std::size_t ring = 0; ring < pieces.ringEnds.size(); ++ring) {
        const Ring corners = pointsOf(ringOf(pieces, ring), points);
        entries.push_back({*std::min_element(corners.begin(), corners.end(), lexicographicLess), ring});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return lexicographicLess(a.smallest, b.smallest); });
    CellPieces sorted;
    for (const Entry& entry : entries) {
        const std::span<const CellCorner> ring = ringOf(pieces, entry.ring);
        sorted.corners.insert(sorted.corners.end(), ring.begin(), ring.end());
        sorted.ringEnds.push_back(static_cast<std::uint32_t>(sorted.corners.size()));
        sorted.pieceEnds.push_back(static_cast<std::uint32_t>(sorted.ringEnds.size()));
    }
    pieces = std::move(sorted);
}

}  // namespace

void CellPieces::clear() {
    corners.clear();
    ringEnds.clear();
    pieceEnds.clear();
}

CellClipper::CellClipper(const Delaunay& delaunay, const std::vector<std::uint32_t>& outgoing,
                         const OutlineTrace& trace, PointNumbers numbers, std::span<const Vec2> points)
    : m_delaunay(delaunay),
      m_diagram(delaunay),
      m_outgoing(outgoing),
      m_trace(trace),
      m_numbers(numbers),
      m_points(points),
      m_exits(trace.arcs.size()) {
    m_crossings.reserve(kReserved);
}

void CellClipper::clip(std::uint32_t site, CellPieces& pieces) {
    pieces.clear();
    collect(site);
    if (!areInOrder()) sortCrossings(site);
    linkExits();
    const auto endPiece = [&] {
        pieces.ringEnds.push_back(static_cast<std::uint32_t>(pieces.corners.size()));
        pieces.pieceEnds.push_back(static_cast<std::uint32_t>(pieces.ringEnds.size()));
    };
    for (std::size_t crossing = 0; crossing < m_crossings.size(); ++crossing) {
        if (m_crossings[crossing].isEntry || m_crossings[crossing].isVisited) continue;
        addPieceFrom(crossing, pieces);
        endPiece();
    }
    if (pieces.pieceEnds.size() > 1) sortPieces(pieces, m_points);
    if (m_rings.empty()) return;
    if (m_crossings.empty()) {
        // Whole rings lie inside the cell: the outline itself, or only holes in an otherwise whole cell.
        const auto outer = std::find_if(m_rings.begin(), m_rings.end(),
                                        [&](std::uint32_t arc) { return m_trace.arcs[arc].ring == 0; });
        if (outer == m_rings.end()) {
            appendCorners(m_outgoing[site], m_outgoing[site], pieces);
        } else {
            appendBoundaryArc(m_trace.arcs[*outer], pieces);
            m_rings.erase(outer);
        }
        endPiece();
    }
    addHoles(pieces);
}

void CellClipper::collect(std::uint32_t site) {
    m_crossings.clear();
    m_rings.clear();
    for (std::uint32_t p = m_trace.firstArc[site]; p != kNone; p = m_trace.arcs[p].nextInCell) {
        const BoundaryArc& arc = m_trace.arcs[p];
        if (arc.leave == kNone) {
            m_rings.push_back(p);
            continue;
        }
        const std::uint32_t entry = m_delaunay.twin(m_trace.crossings[arc.enter].halfEdge);
        m_crossings.push_back({entry, kNone, arc.enter, p, kNone, true, false});
        m_crossings.push_back({m_trace.crossings[arc.leave].halfEdge, kNone, arc.leave, p, kNone, false, false});
    }
    std::sort(m_rings.begin(), m_rings.end());
}

/// Two crossings on different edges are in order. Most cells have no others.
bool CellClipper::areInOrder() const {
    return m_crossings.empty() || (m_crossings.size() == 2 && m_crossings[0].halfEdge != m_crossings[1].halfEdge);
}

void CellClipper::setPositions(std::uint32_t site) {
    std::uint32_t position = 0, spoke = m_outgoing[site];
    do {
        for (BoundaryCrossing& crossing : m_crossings) {
            if (crossing.halfEdge == spoke) crossing.position = position;
        }
        ++position;
        spoke = nextAround(m_delaunay, spoke);
    } while (spoke != m_outgoing[site]);
}

void CellClipper::sortCrossings(std::uint32_t site) {
    setPositions(site);
    std::sort(m_crossings.begin(), m_crossings.end(), [&](const BoundaryCrossing& a, const BoundaryCrossing& b) {
        if (a.position != b.position) return a.position < b.position;
        if (a.crossing == b.crossing) return false;
        return m_diagram.crossesBefore(site, targetOf(m_delaunay, a.halfEdge),
                                       m_trace.lineOf(m_trace.crossings[a.crossing]),
                                       m_trace.lineOf(m_trace.crossings[b.crossing]));
    });
}

/// Finds the exit of each entry: the other crossing of its arc.
void CellClipper::linkExits() {
    for (std::uint32_t k = 0; k < m_crossings.size(); ++k) {
        if (!m_crossings[k].isEntry) m_exits[m_crossings[k].arc] = k;
    }
    for (BoundaryCrossing& crossing : m_crossings) {
        if (crossing.isEntry) crossing.exit = m_exits[crossing.arc];
    }
}

/// Adds one piece: from an exit of the outline, counter-clockwise along the cell to the next entry, along the outline
/// to its exit, and so on until the start.
void CellClipper::addPieceFrom(std::size_t crossing, CellPieces& pieces) {
    const std::size_t first = crossing;
    do {
        BoundaryCrossing& exit = m_crossings[crossing];
        RUBBLE_ASSERT(!exit.isEntry && !exit.isVisited);
        exit.isVisited = true;
        const std::size_t next = crossing + 1 < m_crossings.size() ? crossing + 1 : 0;
        const BoundaryCrossing& entry = m_crossings[next];
        RUBBLE_ASSERT(entry.isEntry);
        appendCellBoundary(exit, entry, pieces);
        appendBoundaryArc(m_trace.arcs[entry.arc], pieces);
        crossing = entry.exit;
    } while (crossing != first);
}

void CellClipper::appendBoundaryArc(const BoundaryArc& arc, CellPieces& pieces) const {
    if (arc.enter != kNone) pieces.corners.push_back({m_numbers.crossings + arc.enter, kNone});
    const std::uint32_t begin = m_trace.ringStarts[arc.ring], end = m_trace.ringStarts[arc.ring + 1];
    std::uint32_t vertex = arc.firstVertex;
    for (std::uint32_t i = 0; i < arc.vertexCount; ++i) {
        pieces.corners.push_back({m_numbers.vertices + vertex, kNone});
        vertex = vertex + 1 == end ? begin : vertex + 1;
    }
}

/// Appends the cell's boundary from an exit of the outline to the next entry.
void CellClipper::appendCellBoundary(const BoundaryCrossing& exit, const BoundaryCrossing& entry,
                                     CellPieces& pieces) const {
    pieces.corners.push_back({m_numbers.crossings + exit.crossing, targetOf(m_delaunay, exit.halfEdge)});
    // Crossings are sorted: an entry before the exit on the same edge is reached only after all other edges.
    const bool isOnOneEdge = exit.halfEdge == entry.halfEdge && &exit < &entry;
    if (!isOnOneEdge) appendCorners(exit.halfEdge, entry.halfEdge, pieces);
}

/// Appends the cell's corners from one of its edges to another, given as half-edges from its site; all of them if both
/// are the same.
void CellClipper::appendCorners(std::uint32_t from, std::uint32_t to, CellPieces& pieces) const {
    std::uint32_t spoke = from;
    do {
        const std::uint32_t corner = Delaunay::triangleOf(spoke);
        spoke = nextAround(m_delaunay, spoke);
        pieces.corners.push_back({corner, targetOf(m_delaunay, spoke)});
    } while (spoke != to);
}

/// Adds each ring inside the cell, a hole, to the piece around it.
void CellClipper::addHoles(CellPieces& pieces) const {
    if (m_rings.empty()) return;
    const std::size_t count = pieces.pieceEnds.size();
    std::vector<std::vector<std::uint32_t>> holesOf(count);
    for (const std::uint32_t arc : m_rings) {
        const Vec2 vertex = m_points[m_numbers.vertices + m_trace.arcs[arc].firstVertex];
        std::size_t piece = 0;
        while (piece + 1 < count &&
               containment({pointsOf(ringOf(pieces, piece), m_points), {}}, vertex) == Containment::Outside) {
            ++piece;
        }
        holesOf[piece].push_back(arc);
    }
    CellPieces whole;
    for (std::size_t piece = 0; piece < count; ++piece) {
        const std::span<const CellCorner> outer = ringOf(pieces, piece);
        whole.corners.insert(whole.corners.end(), outer.begin(), outer.end());
        whole.ringEnds.push_back(static_cast<std::uint32_t>(whole.corners.size()));
        for (const std::uint32_t hole : holesOf[piece]) {
            appendBoundaryArc(m_trace.arcs[hole], whole);
            whole.ringEnds.push_back(static_cast<std::uint32_t>(whole.corners.size()));
        }
        whole.pieceEnds.push_back(static_cast<std::uint32_t>(whole.ringEnds.size()));
    }
    pieces = std::move(whole);
}

}  // namespace rubble
