#include "core/fracture/VisitedCell.h"

#include "core/base/Assert.h"

#include <algorithm>

namespace rubble {

namespace {

constexpr std::size_t kUsual = 16;  // more than most cells have of anything

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

bool isSmaller(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Puts pieces of one ring each into the order of their smallest corners.
void sortPieces(CellPieces& pieces, std::span<const Vec2> points) {
    struct Entry {
        Vec2 smallest;
        std::size_t ring;
    };
    std::vector<Entry> entries;
    for (std::size_t ring = 0; ring < pieces.ringEnds.size(); ++ring) {
        const Ring corners = pointsOf(ringOf(pieces, ring), points);
        entries.push_back({*std::min_element(corners.begin(), corners.end(), isSmaller), ring});
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const Entry& a, const Entry& b) { return isSmaller(a.smallest, b.smallest); });
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

CellCutter::CellCutter(const Delaunay& delaunay, const std::vector<std::uint32_t>& outgoing, const OutlineTrace& trace,
                       PointNumbers numbers, std::span<const Vec2> points)
    : m_delaunay(delaunay),
      m_diagram(delaunay),
      m_outgoing(outgoing),
      m_trace(trace),
      m_numbers(numbers),
      m_points(points) {
    m_marks.reserve(kUsual);
}

void CellCutter::cut(std::uint32_t site, CellPieces& pieces) {
    pieces.clear();
    collect(site);
    if (!areInOrder()) sortMarks(site);
    const auto endPiece = [&] {
        pieces.ringEnds.push_back(static_cast<std::uint32_t>(pieces.corners.size()));
        pieces.pieceEnds.push_back(static_cast<std::uint32_t>(pieces.ringEnds.size()));
    };
    for (std::size_t mark = 0; mark < m_marks.size(); ++mark) {
        if (m_marks[mark].isEntry || m_marks[mark].isDone) continue;
        followFrom(mark, pieces);
        endPiece();
    }
    if (pieces.pieceEnds.size() > 1) sortPieces(pieces, m_points);
    if (m_closed.empty()) return;
    if (m_marks.empty()) {
        // Rings lie inside the cell: the outline itself, or only holes in what is otherwise the whole cell.
        const auto outer = std::find_if(m_closed.begin(), m_closed.end(),
                                        [&](std::uint32_t passage) { return m_trace.passages[passage].ring == 0; });
        if (outer == m_closed.end()) {
            appendArc(m_outgoing[site], m_outgoing[site], pieces);
        } else {
            appendPassage(m_trace.passages[*outer], pieces);
            m_closed.erase(outer);
        }
        endPiece();
    }
    addHoles(pieces);
}

void CellCutter::collect(std::uint32_t site) {
    m_marks.clear();
    m_closed.clear();
    for (std::uint32_t p = m_trace.firstPassage[site]; p != kNone; p = m_trace.passages[p].nextInCell) {
        const OutlinePassage& passage = m_trace.passages[p];
        if (passage.leave == kNone) {
            m_closed.push_back(p);
            continue;
        }
        const std::uint32_t entry = m_delaunay.twin(m_trace.crossings[passage.enter].halfEdge);
        m_marks.push_back({entry, kNone, passage.enter, p, true, false});
        m_marks.push_back({m_trace.crossings[passage.leave].halfEdge, kNone, passage.leave, p, false, false});
    }
    std::sort(m_closed.begin(), m_closed.end());
}

/// Two marks on two edges follow each other around the cell whichever stands first. Most cells have no others.
bool CellCutter::areInOrder() const {
    return m_marks.empty() || (m_marks.size() == 2 && m_marks[0].halfEdge != m_marks[1].halfEdge);
}

void CellCutter::placeMarks(std::uint32_t site) {
    std::uint32_t place = 0, spoke = m_outgoing[site];
    do {
        for (Mark& mark : m_marks) {
            if (mark.halfEdge == spoke) mark.place = place;
        }
        ++place;
        spoke = nextAround(m_delaunay, spoke);
    } while (spoke != m_outgoing[site]);
}

void CellCutter::sortMarks(std::uint32_t site) {
    placeMarks(site);
    std::sort(m_marks.begin(), m_marks.end(), [&](const Mark& a, const Mark& b) {
        if (a.place != b.place) return a.place < b.place;
        if (a.crossing == b.crossing) return false;
        return m_diagram.crossesBefore(site, targetOf(m_delaunay, a.halfEdge),
                                       m_trace.lineOf(m_trace.crossings[a.crossing]),
                                       m_trace.lineOf(m_trace.crossings[b.crossing]));
    });
}

/// One piece: from where the outline leaves the cell, counter-clockwise along the cell to where it enters next, along
/// the outline to where it leaves again, and so on until back.
void CellCutter::followFrom(std::size_t mark, CellPieces& pieces) {
    const std::size_t first = mark;
    do {
        Mark& exit = m_marks[mark];
        RUBBLE_ASSERT(!exit.isEntry && !exit.isDone);
        exit.isDone = true;
        const std::size_t next = mark + 1 < m_marks.size() ? mark + 1 : 0;
        const Mark& entry = m_marks[next];
        RUBBLE_ASSERT(entry.isEntry);
        appendBoundary(exit, entry, pieces);
        appendPassage(m_trace.passages[entry.passage], pieces);
        for (mark = 0; m_marks[mark].isEntry || m_marks[mark].passage != entry.passage;) ++mark;
    } while (mark != first);
}

void CellCutter::appendPassage(const OutlinePassage& passage, CellPieces& pieces) const {
    if (passage.enter != kNone) pieces.corners.push_back({m_numbers.crossings + passage.enter, kNone});
    const std::uint32_t begin = m_trace.ringStarts[passage.ring], end = m_trace.ringStarts[passage.ring + 1];
    std::uint32_t vertex = passage.firstVertex;
    for (std::uint32_t i = 0; i < passage.vertexCount; ++i) {
        pieces.corners.push_back({m_numbers.vertices + vertex, kNone});
        vertex = vertex + 1 == end ? begin : vertex + 1;
    }
}

/// The cell's own boundary from where the outline leaves to where it enters again.
void CellCutter::appendBoundary(const Mark& exit, const Mark& entry, CellPieces& pieces) const {
    pieces.corners.push_back({m_numbers.crossings + exit.crossing, targetOf(m_delaunay, exit.halfEdge)});
    // Marks are sorted, so that an entry which stands before the exit on the same edge is reached all the way round.
    const bool isOnOneEdge = exit.halfEdge == entry.halfEdge && &exit < &entry;
    if (!isOnOneEdge) appendArc(exit.halfEdge, entry.halfEdge, pieces);
}

/// The cell's corners from one of its edges to another, named by half-edges from its site; all of them where both are one.
void CellCutter::appendArc(std::uint32_t from, std::uint32_t to, CellPieces& pieces) const {
    std::uint32_t spoke = from;
    do {
        const std::uint32_t corner = Delaunay::triangleOf(spoke);
        spoke = nextAround(m_delaunay, spoke);
        pieces.corners.push_back({corner, targetOf(m_delaunay, spoke)});
    } while (spoke != to);
}

/// Gives every ring that lies inside the cell, a hole, to the piece around it.
void CellCutter::addHoles(CellPieces& pieces) const {
    if (m_closed.empty()) return;
    const std::size_t count = pieces.pieceEnds.size();
    std::vector<std::vector<std::uint32_t>> holesOf(count);
    for (const std::uint32_t passage : m_closed) {
        const Vec2 vertex = m_points[m_numbers.vertices + m_trace.passages[passage].firstVertex];
        std::size_t piece = 0;
        while (piece + 1 < count &&
               containment({pointsOf(ringOf(pieces, piece), m_points), {}}, vertex) == Containment::Outside) {
            ++piece;
        }
        holesOf[piece].push_back(passage);
    }
    CellPieces whole;
    for (std::size_t piece = 0; piece < count; ++piece) {
        const std::span<const CellCorner> outer = ringOf(pieces, piece);
        whole.corners.insert(whole.corners.end(), outer.begin(), outer.end());
        whole.ringEnds.push_back(static_cast<std::uint32_t>(whole.corners.size()));
        for (const std::uint32_t hole : holesOf[piece]) {
            appendPassage(m_trace.passages[hole], whole);
            whole.ringEnds.push_back(static_cast<std::uint32_t>(whole.corners.size()));
        }
        whole.pieceEnds.push_back(static_cast<std::uint32_t>(whole.ringEnds.size()));
    }
    pieces = std::move(whole);
}

}  // namespace rubble
