#include "core/geometry/polygon/RingArrangement.h"

#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <set>

namespace rubble {

namespace {

bool containsInInterior(const SweptEdge& edge, Vec2 point) {
    return lexicographicLess(edge.left, point) && lexicographicLess(point, edge.right) &&
           orient2d(edge.left, edge.right, point) == 0;
}

bool boundsOverlap(const SweptEdge& a, const SweptEdge& b) {
    const auto [aLow, aHigh] = std::minmax(a.left.y, a.right.y);
    const auto [bLow, bHigh] = std::minmax(b.left.y, b.right.y);
    return a.left.x <= b.right.x && b.left.x <= a.right.x && aLow <= bHigh && bLow <= aHigh;
}

bool cross(const SweptEdge& a, const SweptEdge& b) {
    return orient2d(a.left, a.right, b.left) * orient2d(a.left, a.right, b.right) < 0 &&
           orient2d(b.left, b.right, a.left) * orient2d(b.left, b.right, a.right) < 0;
}

/// Whether two edges share more than one end.
bool intersect(const SweptEdge& a, const SweptEdge& b) {
    if (!boundsOverlap(a, b)) return false;
    return (a.left == b.left && a.right == b.right) || cross(a, b) || containsInInterior(a, b.left) ||
           containsInInterior(a, b.right) || containsInInterior(b, a.left) || containsInInterior(b, a.right);
}

/// Orders edges on the sweep line from bottom to top; edges that touch there are equivalent.
struct IsBelow {
    const std::vector<SweptEdge>* edges;
    std::size_t* comparisons;
    bool operator()(std::uint32_t first, std::uint32_t second) const {
        ++*comparisons;
        return first != second && isBelow((*edges)[first], (*edges)[second]);
    }
};

class RingSweep {
public:
    explicit RingSweep(const IndexedCorners& corners)
        : m_corners(corners), m_edges(sweptEdges(corners)), m_status(IsBelow{&m_edges, &m_comparisons}) {
        m_statusEntry.resize(m_edges.size(), m_status.end());
        m_isSuspect.resize(m_edges.size(), false);
        m_isCounterClockwise.resize(corners.ringCount(), false);
        m_isVisited.resize(corners.ringCount(), false);
        m_parent.resize(corners.ringCount(), kNone);
    }

    RingArrangement run(std::size_t maxContacts) {
        const std::vector<std::uint32_t> order = sweepOrder(m_corners);
        std::size_t groupEnd = 0;
        // A corner on an edge makes both its edges suspects: up to two suspects per contact.
        for (std::size_t i = 0; i < order.size() && m_suspects.size() <= 2 * maxContacts; i = groupEnd) {
            while (groupEnd < order.size() && m_corners.points[order[groupEnd]] == m_corners.points[order[i]])
                ++groupEnd;
            processPoint(std::span(order).subspan(i, groupEnd - i));
        }
        for (const std::uint32_t edge : m_suspects) compareWithAll(edge);
        std::sort(m_contacts.begin(), m_contacts.end());
        m_contacts.erase(std::unique(m_contacts.begin(), m_contacts.end()), m_contacts.end());
        if (!m_contacts.empty()) m_parent.clear();
        return {std::move(m_contacts), std::move(m_parent), !m_suspects.empty(), m_comparisons};
    }

private:
    using Status = std::set<std::uint32_t, IsBelow>;
    using Kind = BoundaryContact::Kind;

    /// Processes the corners at one point: removes the edges that end there from the status, then inserts those that
    /// start.
    void processPoint(std::span<const std::uint32_t> group) {
        for (std::size_t i = 1; i < group.size(); ++i) m_contacts.push_back({group[0], group[i], Kind::CornersMeet});
        const Vec2 point = m_corners.points[group[0]];
        for (const std::uint32_t corner : group)
            for (const std::uint32_t edge : {corner, m_corners.previous[corner]})
                if (m_edges[edge].right == point) removeEdge(edge);
        for (const std::uint32_t corner : group) {
            for (const std::uint32_t edge : {corner, m_corners.previous[corner]})
                if (m_edges[edge].left == point) insertEdge(edge);
            findParent(corner);
        }
    }

    void addSuspect(std::uint32_t edge) {
        m_isSuspect[edge] = true;
        m_suspects.push_back(edge);
    }

    void insertEdge(std::uint32_t edge) {
        const auto [entry, isNew] = m_status.insert(edge);
        if (!isNew) return addSuspect(edge);
        const auto above = std::next(entry);
        const bool intersectsBelow = entry != m_status.begin() && intersect(m_edges[*std::prev(entry)], m_edges[edge]);
        if (intersectsBelow || (above != m_status.end() && intersect(m_edges[edge], m_edges[*above]))) {
            m_status.erase(entry);
            return addSuspect(edge);
        }
        m_statusEntry[edge] = entry;
    }

    void removeEdge(std::uint32_t edge) {
        if (m_isSuspect[edge]) return;
        auto above = m_status.erase(m_statusEntry[edge]);
        while (above != m_status.begin() && above != m_status.end() &&
               intersect(m_edges[*std::prev(above)], m_edges[*above])) {
            addSuspect(*above);
            above = m_status.erase(above);
        }
    }

    /// At the first corner of a ring: determines its winding and the ring below it.
    void findParent(std::uint32_t corner) {
        const std::uint32_t ring = m_corners.ring[corner];
        if (m_isVisited[ring]) return;
        m_isVisited[ring] = true;
        const std::uint32_t before = m_corners.previous[corner];
        if (m_isSuspect[corner] || m_isSuspect[before]) return;
        m_isCounterClockwise[ring] = m_status.key_comp()(corner, before);
        const auto entry = m_statusEntry[m_isCounterClockwise[ring] ? corner : before];
        if (entry == m_status.begin()) return;
        const std::uint32_t below = *std::prev(entry);
        const std::uint32_t ringBelow = m_corners.ring[below];
        const bool isInside = m_edges[below].runsRight == m_isCounterClockwise[ringBelow];
        m_parent[ring] = isInside ? ringBelow : m_parent[ringBelow];
    }

    void compareWithAll(std::uint32_t edge) {
        m_comparisons += m_edges.size();
        for (std::uint32_t other = 0; other < m_edges.size(); ++other) {
            if (other == edge || !boundsOverlap(m_edges[edge], m_edges[other])) continue;
            if (cross(m_edges[edge], m_edges[other]))
                m_contacts.push_back({std::min(edge, other), std::max(edge, other), Kind::EdgesCross});
            addCornersInside(edge, other);
            addCornersInside(other, edge);
        }
    }

    void addCornersInside(std::uint32_t edge, std::uint32_t other) {
        for (const std::uint32_t corner : {other, m_corners.next[other]})
            if (containsInInterior(m_edges[edge], m_corners.points[corner]))
                m_contacts.push_back({corner, edge, Kind::CornerOnEdge});
    }

    const IndexedCorners& m_corners;
    std::vector<SweptEdge> m_edges;
    std::size_t m_comparisons = 0;
    Status m_status;
    std::vector<Status::iterator> m_statusEntry;  // of each edge in the status
    std::vector<bool> m_isSuspect;                // edges that were removed from the sweep
    std::vector<std::uint32_t> m_suspects;        // these edges, in order
    std::vector<bool> m_isCounterClockwise;       // of each visited ring
    std::vector<bool> m_isVisited;
    std::vector<std::uint32_t> m_parent;
    std::vector<BoundaryContact> m_contacts;
};

}  // namespace

RingArrangement ringArrangement(const IndexedCorners& corners, std::size_t maxContacts) {
    return RingSweep(corners).run(maxContacts);
}

}  // namespace rubble
