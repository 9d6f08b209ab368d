#include "core/geometry/SweepTriangulation.h"

#include "core/geometry/Predicates.h"

#include <set>

namespace rubble {

// Glossary. The sweep line goes from left to right. A *lower edge* runs right: the interior lies above it. Between a lower
// edge and the next edge above it lies an *interval* of the interior. Its *chain* is the border, from bottom to top, of
// what has been cut into triangles so far: it starts at the left end of the lower edge, ends at that of the upper one
// and nowhere makes room for a triangle to its right. The interval's *latest* corner sees everything that comes next.

namespace {

constexpr std::uint32_t kNoNode = 0xffffffffu;

/// A corner in a chain.
struct ChainNode {
    std::uint32_t corner;
    std::uint32_t below = kNoNode;
    std::uint32_t above = kNoNode;
};

/// An interval's chain, by nodes.
struct Interval {
    std::uint32_t bottom = kNoNode;
    std::uint32_t top = kNoNode;
    std::uint32_t latest = kNoNode;
};

/// Orders lower edges that cross the sweep line, and points on it, from below to above.
struct IsBelow {
    using is_transparent = void;
    const NumberedCorners* corners;

    int side(std::uint32_t edge, Vec2 point) const {
        return orient2d(corners->points[edge], corners->points[corners->next[edge]], point);
    }
    bool operator()(std::uint32_t edge, Vec2 point) const { return side(edge, point) > 0; }
    bool operator()(Vec2 point, std::uint32_t edge) const { return side(edge, point) < 0; }
    bool operator()(std::uint32_t a, std::uint32_t b) const {
        if (a == b) return false;
        const Vec2 startA = corners->points[a], startB = corners->points[b];
        if (startA == startB) return side(a, corners->points[corners->next[b]]) > 0;
        return sweepsBefore(startA, startB) ? side(a, startB) > 0 : side(b, startA) < 0;
    }
};

class SweepTriangulation {
public:
    explicit SweepTriangulation(const NumberedCorners& corners)
        : m_corners(corners), m_status(IsBelow{&corners}), m_intervals(corners.points.size()) {
        m_place.resize(corners.points.size(), m_status.end());
        m_nodes.reserve(2 * corners.points.size());
        m_triangles.reserve(corners.points.size() + 2 * corners.ringCount());
    }

    std::optional<std::vector<CornerTriangle>> run() {
        const std::vector<std::uint32_t> order = sweepOrder(m_corners);
        std::size_t groupEnd = 0;
        for (std::size_t i = 0; i < order.size(); i = groupEnd) {
            while (groupEnd < order.size() && point(order[groupEnd]) == point(order[i])) ++groupEnd;
            // Where corners meet, all lower edges that end leave before any that starts enters.
            for (std::size_t k = i; k < groupEnd; ++k)
                if (!closeLowerEdge(order[k])) return std::nullopt;
            for (std::size_t k = i; k < groupEnd; ++k)
                if (!meet(order[k])) return std::nullopt;
        }
        return std::move(m_triangles);
    }

private:
    using Status = std::set<std::uint32_t, IsBelow>;

    Vec2 point(std::uint32_t corner) const { return m_corners.points[corner]; }

    bool closeLowerEdge(std::uint32_t corner) {
        const std::uint32_t edge = m_corners.previous[corner];
        if (!sweepsBefore(point(edge), point(corner))) return true;
        if (m_place[edge] == m_status.end()) return false;
        m_status.erase(m_place[edge]);
        return true;
    }

    bool openLowerEdge(std::uint32_t edge) {
        const auto [place, isNew] = m_status.insert(edge);
        if (isNew) m_place[edge] = place;
        return isNew;
    }

    bool meet(std::uint32_t corner) {
        const bool cameFromLeft = sweepsBefore(point(m_corners.previous[corner]), point(corner));
        const bool goesRight = sweepsBefore(point(corner), point(m_corners.next[corner]));
        if (cameFromLeft && goesRight) return continueBelow(corner);
        if (!cameFromLeft && !goesRight) return continueAbove(corner);
        const int turn = orient2d(point(m_corners.previous[corner]), point(corner), point(m_corners.next[corner]));
        if (turn == 0) return false;
        if (goesRight) return turn > 0 ? start(corner) : split(corner);
        return turn > 0 ? end(corner) : merge(corner);
    }

    bool start(std::uint32_t corner) {
        const Interval* below = intervalBelow(corner);
        if (below != nullptr && sideOfUpperEdge(*below, corner) < 0) return false;
        const std::uint32_t node = newNode(corner);
        m_intervals[corner] = {node, node, node};
        return openLowerEdge(corner);
    }

    bool continueBelow(std::uint32_t corner) {
        m_intervals[corner] = m_intervals[m_corners.previous[corner]];
        putBelow(m_intervals[corner], corner);
        return openLowerEdge(corner);
    }

    bool continueAbove(std::uint32_t corner) {
        Interval* interval = intervalBelow(corner);
        if (interval == nullptr || !isEndOfUpperEdge(*interval, corner)) return false;
        putAbove(*interval, corner);
        return true;
    }

    bool end(std::uint32_t corner) {
        Interval& interval = m_intervals[m_corners.previous[corner]];
        if (!isEndOfUpperEdge(interval, corner)) return false;
        putBelow(interval, corner);
        return m_nodes[interval.bottom].above == interval.top;
    }

    /// The interval around the corner becomes two, parted by the diagonal to its latest corner.
    bool split(std::uint32_t corner) {
        Interval* lower = intervalBelow(corner);
        if (lower == nullptr || sideOfUpperEdge(*lower, corner) >= 0) return false;
        const std::uint32_t seen = lower->latest, copy = newNode(m_nodes[seen].corner);
        Interval upper{copy, lower->top == seen ? copy : lower->top, copy};
        if (m_nodes[seen].above != kNoNode) link(copy, m_nodes[seen].above);
        m_nodes[seen].above = kNoNode;
        lower->top = seen;
        putAbove(*lower, corner);
        putBelow(upper, corner);
        m_intervals[corner] = upper;
        return openLowerEdge(corner);
    }

    /// The intervals below and above the corner become one.
    bool merge(std::uint32_t corner) {
        Interval* lower = intervalBelow(corner);
        if (lower == nullptr || !isEndOfUpperEdge(*lower, corner)) return false;
        Interval& upper = m_intervals[m_corners.previous[corner]];
        putAbove(*lower, corner);
        putBelow(upper, corner);
        link(lower->top, m_nodes[upper.bottom].above);
        lower->top = upper.top;
        return true;
    }

    Interval* intervalBelow(std::uint32_t corner) {
        const auto above = m_status.lower_bound(point(corner));
        return above == m_status.begin() ? nullptr : &m_intervals[*std::prev(above)];
    }

    /// Whether the edge above the interval, which ends at the chain's top, starts at the corner.
    bool isEndOfUpperEdge(const Interval& interval, std::uint32_t corner) const {
        return m_nodes[interval.top].corner == m_corners.next[corner];
    }

    /// +1 where the corner lies above the edge above the interval, -1 where it lies below.
    int sideOfUpperEdge(const Interval& interval, std::uint32_t corner) const {
        const std::uint32_t top = m_nodes[interval.top].corner;
        return orient2d(point(top), point(m_corners.previous[top]), point(corner));
    }

    std::uint32_t newNode(std::uint32_t corner) {
        m_nodes.push_back({corner});
        return static_cast<std::uint32_t>(m_nodes.size()) - 1;
    }

    void link(std::uint32_t below, std::uint32_t above) {
        m_nodes[below].above = above;
        m_nodes[above].below = below;
    }

    /// Joins the corner to the bottom of a chain and cuts off every triangle that it now sees.
    void putBelow(Interval& interval, std::uint32_t corner) {
        const std::uint32_t node = newNode(corner);
        std::uint32_t near = interval.bottom;
        for (std::uint32_t far = m_nodes[near].above; far != kNoNode && addTriangle(node, far, near);
             far = m_nodes[near].above)
            near = far;
        link(node, near);
        interval.bottom = interval.latest = node;
    }

    void putAbove(Interval& interval, std::uint32_t corner) {
        const std::uint32_t node = newNode(corner);
        std::uint32_t near = interval.top;
        for (std::uint32_t far = m_nodes[near].below; far != kNoNode && addTriangle(node, near, far);
             far = m_nodes[near].below)
            near = far;
        link(near, node);
        interval.top = interval.latest = node;
    }

    bool addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const CornerTriangle triangle{m_nodes[a].corner, m_nodes[b].corner, m_nodes[c].corner};
        if (orient2d(point(triangle[0]), point(triangle[1]), point(triangle[2])) <= 0) return false;
        m_triangles.push_back(triangle);
        return true;
    }

    const NumberedCorners& m_corners;
    Status m_status;                        // the lower edges that cross the sweep line
    std::vector<Status::iterator> m_place;  // of each lower edge
    std::vector<Interval> m_intervals;      // by lower edge
    std::vector<ChainNode> m_nodes;
    std::vector<CornerTriangle> m_triangles;
};

}  // namespace

std::optional<std::vector<CornerTriangle>> sweptTriangles(const NumberedCorners& corners) {
    return SweepTriangulation(corners).run();
}

}  // namespace rubble
