#include "core/geometry/EdgeSweep.h"

#include "core/geometry/Predicates.h"

#include <algorithm>
#include <set>

namespace rubble {

namespace {

/// An edge from its end that the sweep meets first to the other.
struct SweptEdge {
    Vec2 left;
    Vec2 right;
    bool runsRight = false;  // whether its ring runs from left to right along it
};

bool liesInside(const SweptEdge& edge, Vec2 point) {
    return sweepsBefore(edge.left, point) && sweepsBefore(point, edge.right) &&
           orient2d(edge.left, edge.right, point) == 0;
}

bool boxesMeet(const SweptEdge& a, const SweptEdge& b) {
    const auto [aLow, aHigh] = std::minmax(a.left.y, a.right.y);
    const auto [bLow, bHigh] = std::minmax(b.left.y, b.right.y);
    return a.left.x <= b.right.x && b.left.x <= a.right.x && aLow <= bHigh && bLow <= aHigh;
}

bool cross(const SweptEdge& a, const SweptEdge& b) {
    return orient2d(a.left, a.right, b.left) * orient2d(a.left, a.right, b.right) < 0 &&
           orient2d(b.left, b.right, a.left) * orient2d(b.left, b.right, a.right) < 0;
}

/// True where two edges have more in common than one end.
bool collide(const SweptEdge& a, const SweptEdge& b) {
    if (!boxesMeet(a, b)) return false;
    return (a.left == b.left && a.right == b.right) || cross(a, b) || liesInside(a, b.left) || liesInside(a, b.right) ||
           liesInside(b, a.left) || liesInside(b, a.right);
}

/// Orders edges that cross the sweep line at the same time from below to above; edges that touch there are equal.
struct IsBelow {
    const std::vector<SweptEdge>* edges;
    bool operator()(std::uint32_t first, std::uint32_t second) const {
        const SweptEdge& a = (*edges)[first];
        const SweptEdge& b = (*edges)[second];
        if (first == second) return false;
        if (a.left == b.left) return orient2d(a.left, a.right, b.right) > 0;
        if (sweepsBefore(a.left, b.left)) return orient2d(a.left, a.right, b.left) > 0;
        return orient2d(b.left, b.right, a.left) < 0;
    }
};

class EdgeSweep {
public:
    explicit EdgeSweep(const NumberedCorners& corners)
        : m_corners(corners), m_edges(edgesOf(corners)), m_status(IsBelow{&m_edges}) {
        m_place.resize(m_edges.size(), m_status.end());
        m_isSuspect.resize(m_edges.size(), false);
        m_isCounterClockwise.resize(corners.ringCount(), false);
        m_wasMet.resize(corners.ringCount(), false);
        m_parent.resize(corners.ringCount(), kNoRing);
    }

    RingArrangement run(std::size_t most) {
        const std::vector<std::uint32_t> order = sweepOrder(m_corners);
        std::size_t groupEnd = 0;
        // A corner on an edge makes suspects of both its own edges: twice as many suspects as contacts.
        for (std::size_t i = 0; i < order.size() && m_suspects.size() <= 2 * most; i = groupEnd) {
            while (groupEnd < order.size() && m_corners.points[order[groupEnd]] == m_corners.points[order[i]])
                ++groupEnd;
            meetPoint(std::span(order).subspan(i, groupEnd - i));
        }
        for (const std::uint32_t edge : m_suspects) compareWithAll(edge);
        std::sort(m_contacts.begin(), m_contacts.end());
        m_contacts.erase(std::unique(m_contacts.begin(), m_contacts.end()), m_contacts.end());
        if (!m_contacts.empty()) m_parent.clear();
        return {std::move(m_contacts), std::move(m_parent), !m_suspects.empty()};
    }

private:
    using Status = std::set<std::uint32_t, IsBelow>;
    using Kind = BoundaryContact::Kind;

    static std::vector<SweptEdge> edgesOf(const NumberedCorners& corners) {
        std::vector<SweptEdge> edges(corners.points.size());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const Vec2 from = corners.points[i], to = corners.points[corners.next[i]];
            edges[i] = sweepsBefore(from, to) ? SweptEdge{from, to, true} : SweptEdge{to, from, false};
        }
        return edges;
    }

    /// Corners that lie on one point: first all edges that end there leave the status, then all that start enter.
    void meetPoint(std::span<const std::uint32_t> group) {
        for (std::size_t i = 1; i < group.size(); ++i) m_contacts.push_back({group[0], group[i], Kind::CornersMeet});
        const Vec2 point = m_corners.points[group[0]];
        for (const std::uint32_t corner : group)
            for (const std::uint32_t edge : {corner, m_corners.previous[corner]})
                if (m_edges[edge].right == point) leave(edge);
        for (const std::uint32_t corner : group) {
            for (const std::uint32_t edge : {corner, m_corners.previous[corner]})
                if (m_edges[edge].left == point) enter(edge);
            findParent(corner);
        }
    }

    void suspect(std::uint32_t edge) {
        m_isSuspect[edge] = true;
        m_suspects.push_back(edge);
    }

    void enter(std::uint32_t edge) {
        const auto [place, isNew] = m_status.insert(edge);
        if (!isNew) return suspect(edge);
        const auto above = std::next(place);
        const bool collidesBelow = place != m_status.begin() && collide(m_edges[*std::prev(place)], m_edges[edge]);
        if (collidesBelow || (above != m_status.end() && collide(m_edges[edge], m_edges[*above]))) {
            m_status.erase(place);
            return suspect(edge);
        }
        m_place[edge] = place;
    }

    void leave(std::uint32_t edge) {
        if (m_isSuspect[edge]) return;
        auto above = m_status.erase(m_place[edge]);
        while (above != m_status.begin() && above != m_status.end() &&
               collide(m_edges[*std::prev(above)], m_edges[*above])) {
            suspect(*above);
            above = m_status.erase(above);
        }
    }

    /// At the first corner of a ring that the sweep meets: which way the ring runs and what lies below it.
    void findParent(std::uint32_t corner) {
        const std::uint32_t ring = m_corners.ring[corner];
        if (m_wasMet[ring]) return;
        m_wasMet[ring] = true;
        const std::uint32_t before = m_corners.previous[corner];
        if (m_isSuspect[corner] || m_isSuspect[before]) return;
        m_isCounterClockwise[ring] = IsBelow{&m_edges}(corner, before);
        const auto place = m_place[m_isCounterClockwise[ring] ? corner : before];
        if (place == m_status.begin()) return;
        const std::uint32_t below = *std::prev(place);
        const std::uint32_t ringBelow = m_corners.ring[below];
        const bool isInside = m_edges[below].runsRight == m_isCounterClockwise[ringBelow];
        m_parent[ring] = isInside ? ringBelow : m_parent[ringBelow];
    }

    void compareWithAll(std::uint32_t edge) {
        for (std::uint32_t other = 0; other < m_edges.size(); ++other) {
            if (other == edge || !boxesMeet(m_edges[edge], m_edges[other])) continue;
            if (cross(m_edges[edge], m_edges[other]))
                m_contacts.push_back({std::min(edge, other), std::max(edge, other), Kind::EdgesCross});
            addCornersInside(edge, other);
            addCornersInside(other, edge);
        }
    }

    void addCornersInside(std::uint32_t edge, std::uint32_t other) {
        for (const std::uint32_t corner : {other, m_corners.next[other]})
            if (liesInside(m_edges[edge], m_corners.points[corner]))
                m_contacts.push_back({corner, edge, Kind::CornerOnEdge});
    }

    const NumberedCorners& m_corners;
    std::vector<SweptEdge> m_edges;
    Status m_status;
    std::vector<Status::iterator> m_place;   // of each edge in the status
    std::vector<bool> m_isSuspect;           // edges that were taken out
    std::vector<std::uint32_t> m_suspects;   // the same, in order
    std::vector<bool> m_isCounterClockwise;  // of each ring that was met
    std::vector<bool> m_wasMet;
    std::vector<std::uint32_t> m_parent;
    std::vector<BoundaryContact> m_contacts;
};

}  // namespace

RingArrangement arrangementOf(const NumberedCorners& corners, std::size_t most) { return EdgeSweep(corners).run(most); }

}  // namespace rubble
