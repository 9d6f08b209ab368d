#include "core/fracture/cuts/PlanarFaces.h"

#include "core/base/DisjointSets.h"
#include "core/geometry/polygon/IndexedCorners.h"
#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/search/BoxTree.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace rubble {
namespace {

/// Removes the values that occur in both lists.
void cancelPairs(std::vector<std::uint32_t>& left, std::vector<std::uint32_t>& right) {
    for (std::size_t k = 0; k < left.size();) {
        const auto same = std::ranges::find(right, left[k]);
        if (same == right.end()) {
            ++k;
            continue;
        }
        right.erase(same);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    }
}

/// Merges parallel edges into one, with the direction of the first. Of edges of a partition, which enclose a degenerate
/// piece, the outer sides remain; nothing if these are the same piece and no cut runs there.
std::optional<PlanarEdge> mergedEdge(std::span<const PlanarEdge> edges) {
    PlanarEdge merged = edges[0];
    std::vector<std::uint32_t> left, right;
    for (const PlanarEdge& edge : edges) {
        if (edge.group != 0) {
            merged = merged.group == 0 ? PlanarEdge{merged.from, merged.to, edge.group, edge.line} : merged;
            continue;
        }
        const bool isSame = edge.from == edges[0].from;
        left.push_back(isSame ? edge.left : edge.right);
        right.push_back(isSame ? edge.right : edge.left);
    }
    cancelPairs(left, right);
    if (left.empty()) return merged.group == 0 ? std::nullopt : std::optional(merged);
    return PlanarEdge{merged.from, merged.to, 0, kNone, left[0], right[0]};
}

/// The edges sorted by their lower point, parallel ones merged.
std::vector<PlanarEdge> mergedEdges(const PlanarGraph& graph) {
    const auto lower = [](const PlanarEdge& edge) { return std::min(edge.from, edge.to); };
    const auto upper = [](const PlanarEdge& edge) { return std::max(edge.from, edge.to); };
    std::vector<std::uint32_t> ends(graph.points.size() + 1, 0);
    for (const PlanarEdge& edge : graph.edges) ++ends[lower(edge) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<PlanarEdge> sorted(graph.edges.size());
    for (const PlanarEdge& edge : graph.edges) sorted[ends[lower(edge)]++] = edge;
    std::vector<PlanarEdge> merged;
    merged.reserve(sorted.size());
    for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
        while (end < sorted.size() && lower(sorted[end]) == lower(sorted[begin])) ++end;
        const auto at = [&](std::size_t k) { return sorted.begin() + static_cast<std::ptrdiff_t>(k); };
        // Insertion sort: there are hardly ever more than three.
        for (std::size_t k = begin + 1; k < end; ++k) {
            const auto isAbove = [&](const PlanarEdge& one, const PlanarEdge& other) {
                return upper(one) < upper(other);
            };
            std::rotate(std::upper_bound(at(begin), at(k), sorted[k], isAbove), at(k), at(k + 1));
        }
        for (std::size_t first = begin, last = begin; first < end; first = last) {
            while (last < end && upper(sorted[last]) == upper(sorted[first])) ++last;
            if (last - first == 1) {
                merged.push_back(sorted[first]);
            } else if (const auto edge = mergedEdge({&sorted[first], last - first})) {
                merged.push_back(*edge);
            }
        }
    }
    return merged;
}

/// Whether a direction is in the second half of the angular order, which is counter-clockwise and ends straight down.
bool isOnLeftHalf(Vec2 from, Vec2 to) { return to.x < from.x || (to.x == from.x && to.y < from.y); }

/// The edges in a spatial index, for horizontal rays from points to the left.
class EdgesToTheLeft {
public:
    EdgesToTheLeft(const PlanarFaces& faces, std::span<const Vec2> points) : m_tree(boxesOf(faces, points)) {}

    /// The edges whose boxes a ray of a length meets, ascending.
    std::vector<std::uint32_t> within(Vec2 from, double length) const {
        std::vector<std::uint32_t> edges;
        m_tree.visitOverlapping({Vec3(from.x - length, from.y, 0.0), Vec3(from, 0.0)},
                                [&](std::uint32_t edge) { edges.push_back(edge); });
        std::ranges::sort(edges);
        return edges;
    }

private:
    static std::vector<Box3> boxesOf(const PlanarFaces& faces, std::span<const Vec2> points) {
        std::vector<Box3> boxes;
        for (const PlanarEdge& edge : faces.edges) boxes.push_back(boxOf(points[edge.from], points[edge.to]));
        return boxes;
    }

    BoxTree m_tree;
};

class FaceTracer {
public:
    FaceTracer(const PlanarGraph& graph, const TaskContext& task) : m_points(graph.points), m_task(task) {
        m_faces.edges = mergedEdges(graph);
    }

    Result<std::optional<PlanarFaces>> run() {
        do {
            if (m_task.isCancelled()) return TaskContext::cancelled();
            removeDanglingEdges();
            sortAroundPoints();
            if (m_task.isCancelled()) return TaskContext::cancelled();
            traceCycles();
        } while (removeBridges());
        if (!findOuterCycles()) return std::optional<PlanarFaces>();
        if (!findFaces()) return TaskContext::cancelled();
        return std::optional(std::move(m_faces));
    }

private:
    static constexpr std::size_t kMinIndexed = 16;  // components; for fewer all edges are visited

    Vec2 at(std::uint32_t point) const { return m_points[point]; }
    std::uint32_t halfEdgeCount() const { return static_cast<std::uint32_t>(2 * m_faces.edges.size()); }

    void removeEdges(const std::vector<bool>& isRemoved) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < m_faces.edges.size(); ++k) {
            if (isRemoved[k]) {
                m_faces.dangling.push_back(m_faces.edges[k]);
            } else {
                m_faces.edges[kept++] = m_faces.edges[k];
            }
        }
        m_faces.edges.resize(kept);
    }

    /// Removes edges that end at a point of degree 1, repeatedly.
    void removeDanglingEdges() {
        std::vector<std::uint32_t> degrees(m_points.size(), 0),
            sums(m_points.size(), 0);  // of edges; XOR of their indices
        for (std::uint32_t k = 0; k < m_faces.edges.size(); ++k) {
            for (const std::uint32_t end : {m_faces.edges[k].from, m_faces.edges[k].to}) {
                ++degrees[end];
                sums[end] ^= k;
            }
        }
        std::vector<bool> isRemoved;
        for (std::uint32_t start = 0; start < degrees.size(); ++start) {
            for (std::uint32_t point = start; degrees[point] == 1;) {
                isRemoved.resize(m_faces.edges.size(), false);
                const std::uint32_t edge = sums[point];
                isRemoved[edge] = true;
                const std::uint32_t other = m_faces.edges[edge].from ^ m_faces.edges[edge].to ^ point;
                for (const std::uint32_t end : {point, other}) {
                    --degrees[end];
                    sums[end] ^= edge;
                }
                point = other;
            }
        }
        if (!isRemoved.empty()) removeEdges(isRemoved);
    }

    /// Sorts the half-edges around their origins, counter-clockwise.
    void sortAroundPoints() {
        m_begins.assign(m_points.size() + 1, 0);
        for (const PlanarEdge& edge : m_faces.edges) {
            ++m_begins[edge.from + 1];
            ++m_begins[edge.to + 1];
        }
        std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
        m_around.resize(halfEdgeCount());
        std::vector<std::uint32_t> next(m_begins.begin(), m_begins.end() - 1);
        for (std::uint32_t h = 0; h < halfEdgeCount(); ++h) m_around[next[m_faces.origin(h)]++] = h;
        for (std::uint32_t point = 0; point + 1 < m_begins.size(); ++point) {
            const auto begin = m_around.begin() + m_begins[point], end = m_around.begin() + m_begins[point + 1];
            std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
                const Vec2 from = at(point), one = at(m_faces.origin(a ^ 1)), other = at(m_faces.origin(b ^ 1));
                const bool isOneLeft = isOnLeftHalf(from, one), isOtherLeft = isOnLeftHalf(from, other);
                if (isOneLeft != isOtherLeft) return isOtherLeft;
                const int turn = orient2d(from, one, other);
                return turn != 0 ? turn > 0 : a < b;
            });
        }
    }

    void traceCycles() {
        m_faces.next.resize(halfEdgeCount());
        for (std::uint32_t point = 0; point + 1 < m_begins.size(); ++point) {
            const std::uint32_t begin = m_begins[point], end = m_begins[point + 1];
            // A half-edge is followed by the next one clockwise around its end.
            for (std::uint32_t k = begin; k < end; ++k)
                m_faces.next[m_around[k] ^ 1] = m_around[k > begin ? k - 1 : end - 1];
        }
        m_cycleOf.assign(halfEdgeCount(), kNone);
        m_cycles.clear();
        for (std::uint32_t first = 0; first < halfEdgeCount(); ++first) {
            if (m_cycleOf[first] != kNone) continue;
            for (std::uint32_t h = first; m_cycleOf[h] == kNone; h = m_faces.next[h]) m_cycleOf[h] = cycleCount();
            m_cycles.push_back(first);
        }
    }
    std::uint32_t cycleCount() const { return static_cast<std::uint32_t>(m_cycles.size()); }

    /// Removes edges with the same face on both sides. False if there are none.
    bool removeBridges() {
        std::vector<bool> isRemoved;
        for (std::uint32_t edge = 0; edge < m_faces.edges.size(); ++edge) {
            if (m_cycleOf[2 * edge] != m_cycleOf[2 * edge + 1]) continue;
            isRemoved.resize(m_faces.edges.size(), false);
            isRemoved[edge] = true;
        }
        if (isRemoved.empty()) return false;
        removeEdges(isRemoved);
        return true;
    }

    /// Finds the outer cycle of each connected component, which passes its leftmost point. False if the graph is not
    /// planar, by Euler's formula.
    bool findOuterCycles() {
        DisjointSets components(cycleCount());
        for (std::uint32_t edge = 0; edge < m_faces.edges.size(); ++edge)
            components.merge(m_cycleOf[2 * edge], m_cycleOf[2 * edge + 1]);
        m_componentOf = components.roots();
        m_leftmost.assign(cycleCount(), kNone);
        std::size_t points = 0;
        for (std::uint32_t point = 0; point + 1 < m_begins.size(); ++point) {
            if (m_begins[point] == m_begins[point + 1]) continue;
            ++points;
            std::uint32_t& leftmost = m_leftmost[m_componentOf[m_cycleOf[m_around[m_begins[point]]]]];
            if (leftmost == kNone || lexicographicLess(at(point), at(leftmost))) leftmost = point;
        }
        m_isOuter.assign(cycleCount(), false);
        std::size_t count = 0;
        for (std::uint32_t component = 0; component < cycleCount(); ++component) {
            if (m_leftmost[component] == kNone) continue;
            // All edges at the point run to the right: the outer cycle starts with the last of them.
            m_isOuter[m_cycleOf[m_around[m_begins[m_leftmost[component] + 1] - 1]]] = true;
            ++count;
        }
        return points + cycleCount() == m_faces.edges.size() + 2 * count;
    }

    /// Numbers the faces by their outer cycles, and makes each component a hole of the face that contains it. False if
    /// cancelled.
    bool findFaces() {
        std::vector<std::uint32_t> faceOfCycle(cycleCount(), kNone), outer;
        std::uint32_t count = 1;
        for (std::uint32_t cycle = 0; cycle < cycleCount(); ++cycle) {
            if (m_isOuter[cycle]) {
                outer.push_back(cycle);
            } else {
                faceOfCycle[cycle] = count++;
            }
        }
        std::vector<std::uint32_t> enclosing(cycleCount(), kNone);  // of each outer cycle: one of the face around it
        std::optional<EdgesToTheLeft> index;
        m_left = boundsOf(m_points).min.x;
        if (outer.size() >= kMinIndexed) index.emplace(m_faces, m_points);
        for (const std::uint32_t cycle : outer) {
            if (m_task.isCancelled()) return false;
            if (outer.size() > 1)
                enclosing[cycle] = cycleLeftOf(m_leftmost[m_componentOf[cycle]], m_componentOf[cycle], index);
        }
        for (const std::uint32_t cycle : outer) {
            std::uint32_t around = cycle;
            while (around != kNone && m_isOuter[around]) around = enclosing[around];
            faceOfCycle[cycle] = around == kNone ? 0 : faceOfCycle[around];
        }
        listRings(faceOfCycle, count);
        m_faces.faceOf.resize(halfEdgeCount());
        for (std::uint32_t h = 0; h < halfEdgeCount(); ++h) m_faces.faceOf[h] = faceOfCycle[m_cycleOf[h]];
        return true;
    }

    void listRings(const std::vector<std::uint32_t>& faceOfCycle, std::uint32_t count) {
        m_faces.ringsBegin.assign(count + 1, 0);
        for (const std::uint32_t face : faceOfCycle) ++m_faces.ringsBegin[face + 1];
        std::partial_sum(m_faces.ringsBegin.begin(), m_faces.ringsBegin.end(), m_faces.ringsBegin.begin());
        m_faces.rings.resize(cycleCount());
        std::vector<std::uint32_t> next(m_faces.ringsBegin.begin(), m_faces.ringsBegin.end() - 1);
        for (const bool isOuter : {false, true}) {
            for (std::uint32_t cycle = 0; cycle < cycleCount(); ++cycle) {
                if (m_isOuter[cycle] == isOuter) m_faces.rings[next[faceOfCycle[cycle]]++] = m_cycles[cycle];
            }
        }
    }

    /// The first cycle of another component on the horizontal ray from a point to the left; kNone: none.
    std::uint32_t cycleLeftOf(std::uint32_t point, std::uint32_t component,
                              const std::optional<EdgesToTheLeft>& index) const {
        const Vec2 from = at(point);
        std::uint32_t nearest = kNone;
        double best = 0.0;
        Vec2 nearestLow{}, nearestHigh{};
        const auto visit = [&](std::uint32_t edge) {
            const bool isUp = at(m_faces.edges[edge].from).y < at(m_faces.edges[edge].to).y;
            const Vec2 low = at(m_faces.origin(2 * edge + (isUp ? 0 : 1))),
                       high = at(m_faces.origin(2 * edge + (isUp ? 1 : 0)));
            if (!(low.y <= from.y && from.y < high.y) || m_componentOf[m_cycleOf[2 * edge]] == component) return;
            if (orient2d(low, high, from) >= 0) return;
            const double x = low.x + (high.x - low.x) * ((from.y - low.y) / (high.y - low.y));
            const bool isNearer = x > best || (x == best && orient2d(nearestLow, nearestHigh, high) < 0);
            if (nearest != kNone && !isNearer) return;
            best = x, nearestLow = low, nearestHigh = high;
            nearest = 2 * edge + (isUp ? 1 : 0);  // downward: its face lies to the right
        };
        if (!index) {
            for (std::uint32_t edge = 0; edge < m_faces.edges.size(); ++edge) visit(edge);
        }
        const double width = from.x - m_left;
        for (double length = width / static_cast<double>(cycleCount()); index; length *= 2.0) {
            nearest = kNone;
            for (const std::uint32_t edge : index->within(from, length)) visit(edge);
            // Within half of the length: the rounded intersections of edges farther away are not to the right of it.
            if (!(length > 0.0 && length <= width) || (nearest != kNone && best > from.x - length / 2.0)) break;
        }
        return nearest == kNone ? kNone : m_cycleOf[nearest];
    }

    std::span<const Vec2> m_points;
    const TaskContext& m_task;
    PlanarFaces m_faces;
    std::vector<std::uint32_t> m_begins;       // of each point in m_around, and one more
    std::vector<std::uint32_t> m_around;       // half-edges
    std::vector<std::uint32_t> m_cycleOf;      // of each half-edge
    std::vector<std::uint32_t> m_cycles;       // a half-edge of each
    std::vector<std::uint32_t> m_componentOf;  // of each cycle, the component, named by its first cycle
    std::vector<std::uint32_t> m_leftmost;     // point of each component
    std::vector<bool> m_isOuter;               // of each cycle
    double m_left = 0.0;                       // m: the smallest x of all points
};

}  // namespace

Result<std::optional<PlanarFaces>> facesOf(const PlanarGraph& graph, const TaskContext& task) {
    return FaceTracer(graph, task).run();
}

}  // namespace rubble
