#include "core/geometry/polygon/SweepTriangulation.h"

#include "core/base/Index.h"
#include "core/geometry/predicates/Predicates.h"

#include <set>

namespace rubble {

// Glossary. The sweep line moves from left to right. A *lower edge* runs right: the interior is above it. An *interval*
// of the interior on the sweep line is bounded by a lower edge and the next edge above it, the *upper edge*. Its
// *chain* is the boundary, from bottom to top, of the part already triangulated: a reflex chain from the left end of
// the lower edge to that of the upper edge. The interval's *latest* corner (the helper of Hertel and Mehlhorn) is
// visible from the next corner in the interval.

namespace {

/// A corner in a chain.
struct ChainNode {
    std::uint32_t corner;
    std::uint32_t below = kNone;
    std::uint32_t above = kNone;
};

/// The chain of an interval, by nodes.
struct SweptInterval {
    std::uint32_t bottom = kNone;
    std::uint32_t top = kNone;
    std::uint32_t latest = kNone;
};

/// Orders the lower edges and points on the sweep line from bottom to top.
struct IsSweptBelow {
    using is_transparent = void;
    const IndexedCorners* corners;
    std::size_t* steps;

    int side(std::uint32_t edge, Vec2 point) const {
        ++*steps;
        return orient2d(corners->points[edge], corners->points[corners->next[edge]], point);
    }
    bool operator()(std::uint32_t edge, Vec2 point) const { return side(edge, point) > 0; }
    bool operator()(Vec2 point, std::uint32_t edge) const { return side(edge, point) < 0; }
    bool operator()(std::uint32_t a, std::uint32_t b) const {
        if (a == b) return false;
        const Vec2 startA = corners->points[a], startB = corners->points[b];
        if (startA == startB) return side(a, corners->points[corners->next[b]]) > 0;
        return lexicographicLess(startA, startB) ? side(a, startB) > 0 : side(b, startA) < 0;
    }
};

class SweepTriangulation {
public:
    explicit SweepTriangulation(const IndexedCorners& corners)
        : m_corners(corners), m_status(IsSweptBelow{&corners, &m_steps}), m_intervals(corners.points.size()) {
        m_statusEntry.resize(corners.points.size(), m_status.end());
        m_nodes.reserve(2 * corners.points.size());
        m_triangles.reserve(corners.points.size() + 2 * corners.ringCount());
    }

    std::optional<std::vector<CornerTriangle>> run() {
        const std::vector<std::uint32_t> order = sweepOrder(m_corners);
        std::size_t groupEnd = 0;
        for (std::size_t i = 0; i < order.size(); i = groupEnd) {
            while (groupEnd < order.size() && point(order[groupEnd]) == point(order[i])) ++groupEnd;
            // At coinciding corners, all lower edges that end are removed before any that start are inserted.
            for (std::size_t k = i; k < groupEnd; ++k)
                if (!closeLowerEdge(order[k])) return std::nullopt;
            for (std::size_t k = i; k < groupEnd; ++k)
                if (!processCorner(order[k])) return std::nullopt;
        }
        return std::move(m_triangles);
    }

    std::size_t steps() const { return m_steps; }

private:
    using Status = std::set<std::uint32_t, IsSweptBelow>;

    Vec2 point(std::uint32_t corner) const { return m_corners.points[corner]; }

    bool closeLowerEdge(std::uint32_t corner) {
        const std::uint32_t edge = m_corners.previous[corner];
        if (!lexicographicLess(point(edge), point(corner))) return true;
        if (m_statusEntry[edge] == m_status.end()) return false;
        m_status.erase(m_statusEntry[edge]);
        return true;
    }

    bool openLowerEdge(std::uint32_t edge) {
        const auto [entry, isNew] = m_status.insert(edge);
        if (isNew) m_statusEntry[edge] = entry;
        return isNew;
    }

    bool processCorner(std::uint32_t corner) {
        const bool cameFromLeft = lexicographicLess(point(m_corners.previous[corner]), point(corner));
        const bool goesRight = lexicographicLess(point(corner), point(m_corners.next[corner]));
        if (cameFromLeft && goesRight) return continueBelow(corner);
        if (!cameFromLeft && !goesRight) return continueAbove(corner);
        const int orientation =
            orient2d(point(m_corners.previous[corner]), point(corner), point(m_corners.next[corner]));
        if (orientation == 0) return false;
        if (goesRight) return orientation > 0 ? start(corner) : split(corner);
        return orientation > 0 ? end(corner) : merge(corner);
    }

    bool start(std::uint32_t corner) {
        const SweptInterval* below = intervalBelow(corner);
        if (below != nullptr && sideOfUpperEdge(*below, corner) < 0) return false;
        const std::uint32_t node = newNode(corner);
        m_intervals[corner] = {node, node, node};
        return openLowerEdge(corner);
    }

    bool continueBelow(std::uint32_t corner) {
        m_intervals[corner] = m_intervals[m_corners.previous[corner]];
        addBelow(m_intervals[corner], corner);
        return openLowerEdge(corner);
    }

    bool continueAbove(std::uint32_t corner) {
        SweptInterval* interval = intervalBelow(corner);
        if (interval == nullptr || !isEndOfUpperEdge(*interval, corner)) return false;
        addAbove(*interval, corner);
        return true;
    }

    bool end(std::uint32_t corner) {
        SweptInterval& interval = m_intervals[m_corners.previous[corner]];
        if (!isEndOfUpperEdge(interval, corner)) return false;
        addBelow(interval, corner);
        return m_nodes[interval.bottom].above == interval.top;
    }

    /// Splits the interval around the corner by the diagonal to its latest corner.
    bool split(std::uint32_t corner) {
        SweptInterval* lower = intervalBelow(corner);
        if (lower == nullptr || sideOfUpperEdge(*lower, corner) >= 0) return false;
        const std::uint32_t seen = lower->latest, copy = newNode(m_nodes[seen].corner);
        SweptInterval upper{copy, lower->top == seen ? copy : lower->top, copy};
        if (m_nodes[seen].above != kNone) link(copy, m_nodes[seen].above);
        m_nodes[seen].above = kNone;
        lower->top = seen;
        addAbove(*lower, corner);
        addBelow(upper, corner);
        m_intervals[corner] = upper;
        return openLowerEdge(corner);
    }

    /// Merges the intervals below and above the corner.
    bool merge(std::uint32_t corner) {
        SweptInterval* lower = intervalBelow(corner);
        if (lower == nullptr || !isEndOfUpperEdge(*lower, corner)) return false;
        SweptInterval& upper = m_intervals[m_corners.previous[corner]];
        addAbove(*lower, corner);
        addBelow(upper, corner);
        link(lower->top, m_nodes[upper.bottom].above);
        lower->top = upper.top;
        return true;
    }

    SweptInterval* intervalBelow(std::uint32_t corner) {
        const auto above = m_status.lower_bound(point(corner));
        return above == m_status.begin() ? nullptr : &m_intervals[*std::prev(above)];
    }

    /// Whether the upper edge of the interval starts at the corner.
    bool isEndOfUpperEdge(const SweptInterval& interval, std::uint32_t corner) const {
        return m_nodes[interval.top].corner == m_corners.next[corner];
    }

    /// +1 if the corner is above the upper edge, -1 if it is below.
    int sideOfUpperEdge(const SweptInterval& interval, std::uint32_t corner) const {
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

    /// Adds the corner at the bottom of a chain and every triangle visible from it.
    void addBelow(SweptInterval& interval, std::uint32_t corner) {
        const std::uint32_t node = newNode(corner);
        link(node, lastVisible(interval.bottom, &ChainNode::above,
                               [&](std::uint32_t near, std::uint32_t far) { return addTriangle(node, far, near); }));
        interval.bottom = interval.latest = node;
    }

    /// Adds the corner at the top of a chain and every triangle visible from it.
    void addAbove(SweptInterval& interval, std::uint32_t corner) {
        const std::uint32_t node = newNode(corner);
        link(lastVisible(interval.top, &ChainNode::below,
                         [&](std::uint32_t near, std::uint32_t far) { return addTriangle(node, near, far); }),
             node);
        interval.top = interval.latest = node;
    }

    /// Walks along a chain from an end while `add` adds the triangle of a link; returns the node where it stops.
    template <class Add>
    std::uint32_t lastVisible(std::uint32_t near, std::uint32_t ChainNode::*next, Add add) {
        for (std::uint32_t far = m_nodes[near].*next; far != kNone && add(near, far); far = m_nodes[near].*next)
            near = far;
        return near;
    }

    bool addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        ++m_steps;
        const CornerTriangle triangle{m_nodes[a].corner, m_nodes[b].corner, m_nodes[c].corner};
        if (orient2d(point(triangle[0]), point(triangle[1]), point(triangle[2])) <= 0) return false;
        m_triangles.push_back(triangle);
        return true;
    }

    const IndexedCorners& m_corners;
    std::size_t m_steps = 0;
    Status m_status;                              // the lower edges on the sweep line
    std::vector<Status::iterator> m_statusEntry;  // of each lower edge
    std::vector<SweptInterval> m_intervals;       // by lower edge
    std::vector<ChainNode> m_nodes;
    std::vector<CornerTriangle> m_triangles;
};

}  // namespace

std::optional<std::vector<CornerTriangle>> sweepTriangulation(const IndexedCorners& corners, std::size_t* steps) {
    SweepTriangulation sweep(corners);
    std::optional<std::vector<CornerTriangle>> triangles = sweep.run();
    if (steps) *steps += sweep.steps();
    return triangles;
}

}  // namespace rubble
