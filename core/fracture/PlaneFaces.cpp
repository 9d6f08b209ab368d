#include "core/fracture/PlaneFaces.h"

#include "core/geometry/Predicates.h"

#include <algorithm>
#include <numeric>

namespace rubble {
namespace {

/// Takes out what stands on both sides.
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

/// Several edges between the same two points as one, which runs as the first does. Of edges of a partition between which there is
/// nothing left, the outer sides count; none where these are sides of one piece and no cut runs there.
std::optional<PlaneEdge> joinedEdge(std::span<const PlaneEdge> edges) {
    PlaneEdge joined = edges[0];
    std::vector<std::uint32_t> left, right;
    for (const PlaneEdge& edge : edges) {
        if (edge.group != 0) {
            joined = joined.group == 0 ? PlaneEdge{joined.from, joined.to, edge.group, edge.line} : joined;
            continue;
        }
        const bool isSame = edge.from == edges[0].from;
        left.push_back(isSame ? edge.left : edge.right);
        right.push_back(isSame ? edge.right : edge.left);
    }
    cancelPairs(left, right);
    if (left.empty()) return joined.group == 0 ? std::nullopt : std::optional(joined);
    return PlaneEdge{joined.from, joined.to, 0, kNone, left[0], right[0]};
}

/// The edges by their lower point, equal ones joined.
std::vector<PlaneEdge> joinedEdges(const PlaneDrawing& drawing) {
    const auto lower = [](const PlaneEdge& edge) { return std::min(edge.from, edge.to); };
    const auto upper = [](const PlaneEdge& edge) { return std::max(edge.from, edge.to); };
    std::vector<std::uint32_t> ends(drawing.points.size() + 1, 0);
    for (const PlaneEdge& edge : drawing.edges) ++ends[lower(edge) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<PlaneEdge> sorted(drawing.edges.size());
    for (const PlaneEdge& edge : drawing.edges) sorted[ends[lower(edge)]++] = edge;
    std::vector<PlaneEdge> joined;
    joined.reserve(sorted.size());
    for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end) {
        while (end < sorted.size() && lower(sorted[end]) == lower(sorted[begin])) ++end;
        const auto at = [&](std::size_t k) { return sorted.begin() + static_cast<std::ptrdiff_t>(k); };
        // Hardly ever more than three: each is put behind those that are not above it.
        for (std::size_t k = begin + 1; k < end; ++k) {
            const auto isAbove = [&](const PlaneEdge& one, const PlaneEdge& other) {
                return upper(one) < upper(other);
            };
            std::rotate(std::upper_bound(at(begin), at(k), sorted[k], isAbove), at(k), at(k + 1));
        }
        for (std::size_t first = begin, last = begin; first < end; first = last) {
            while (last < end && upper(sorted[last]) == upper(sorted[first])) ++last;
            if (last - first == 1) {
                joined.push_back(sorted[first]);
            } else if (const auto edge = joinedEdge({&sorted[first], last - first})) {
                joined.push_back(*edge);
            }
        }
    }
    return joined;
}

/// Directions from a point, from straight down (which comes last) counter-clockwise.
bool isOnLeftHalf(Vec2 from, Vec2 to) { return to.x < from.x || (to.x == from.x && to.y < from.y); }

bool isSmaller(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Sets of numbers that are joined two by two.
class JoinedSets {
public:
    explicit JoinedSets(std::size_t count) : m_parents(count) { std::iota(m_parents.begin(), m_parents.end(), 0u); }
    std::uint32_t rootOf(std::uint32_t k) {
        while (m_parents[k] != k) k = m_parents[k] = m_parents[m_parents[k]];
        return k;
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = rootOf(a), b = rootOf(b);
        m_parents[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> m_parents;
};

class Tracing {
public:
    Tracing(const PlaneDrawing& drawing, const TaskContext& task) : m_points(drawing.points), m_task(task) {
        m_faces.edges = joinedEdges(drawing);
    }

    Result<std::optional<PlaneFaces>> run() {
        do {
            if (m_task.isCancelled()) return TaskContext::cancelled();
            takeOutDangling();
            sortAroundPoints();
            if (m_task.isCancelled()) return TaskContext::cancelled();
            traceCycles();
        } while (takeOutBridges());
        if (!findOuterCycles()) return std::optional<PlaneFaces>();
        if (!findFaces()) return TaskContext::cancelled();
        return std::optional(std::move(m_faces));
    }

private:
    Vec2 at(std::uint32_t point) const { return m_points[point]; }
    std::uint32_t halfEdgeCount() const { return static_cast<std::uint32_t>(2 * m_faces.edges.size()); }

    void takeOut(const std::vector<bool>& isOut) {
        std::size_t kept = 0;
        for (std::size_t k = 0; k < m_faces.edges.size(); ++k) {
            if (isOut[k]) {
                m_faces.loose.push_back(m_faces.edges[k]);
            } else {
                m_faces.edges[kept++] = m_faces.edges[k];
            }
        }
        m_faces.edges.resize(kept);
    }

    /// Edges that end where no other one does, and what then does so.
    void takeOutDangling() {
        std::vector<std::uint32_t> degrees(m_points.size(), 0),
            sums(m_points.size(), 0);  // of edges; of their numbers, as bits
        for (std::uint32_t k = 0; k < m_faces.edges.size(); ++k) {
            for (const std::uint32_t end : {m_faces.edges[k].from, m_faces.edges[k].to}) {
                ++degrees[end];
                sums[end] ^= k;
            }
        }
        std::vector<bool> isOut;
        for (std::uint32_t start = 0; start < degrees.size(); ++start) {
            for (std::uint32_t point = start; degrees[point] == 1;) {
                isOut.resize(m_faces.edges.size(), false);
                const std::uint32_t edge = sums[point];
                isOut[edge] = true;
                const std::uint32_t other = m_faces.edges[edge].from ^ m_faces.edges[edge].to ^ point;
                for (const std::uint32_t end : {point, other}) {
                    --degrees[end];
                    sums[end] ^= edge;
                }
                point = other;
            }
        }
        if (!isOut.empty()) takeOut(isOut);
    }

    /// Half-edges by their origin, counter-clockwise.
    void sortAroundPoints() {
        m_begins.assign(m_points.size() + 1, 0);
        for (const PlaneEdge& edge : m_faces.edges) {
            ++m_begins[edge.from + 1];
            ++m_begins[edge.to + 1];
        }
        std::partial_sum(m_begins.begin(), m_begins.end(), m_begins.begin());
        m_around.resize(halfEdgeCount());
        std::vector<std::uint32_t> places(m_begins.begin(), m_begins.end() - 1);
        for (std::uint32_t h = 0; h < halfEdgeCount(); ++h) m_around[places[m_faces.origin(h)]++] = h;
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
            // Who comes back along an edge goes on along the one that is next clockwise.
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

    /// Edges with one face on both sides.
    bool takeOutBridges() {
        std::vector<bool> isOut;
        for (std::uint32_t edge = 0; edge < m_faces.edges.size(); ++edge) {
            if (m_cycleOf[2 * edge] != m_cycleOf[2 * edge + 1]) continue;
            isOut.resize(m_faces.edges.size(), false);
            isOut[edge] = true;
        }
        if (isOut.empty()) return false;
        takeOut(isOut);
        return true;
    }

    /// Of each connected part the cycle around it, which comes past its leftmost point. False where the parts do not fit in
    /// a plane, by Euler's formula.
    bool findOuterCycles() {
        JoinedSets parts(cycleCount());
        for (std::uint32_t edge = 0; edge < m_faces.edges.size(); ++edge)
            parts.join(m_cycleOf[2 * edge], m_cycleOf[2 * edge + 1]);
        m_partOf.resize(cycleCount());
        m_leftmost.assign(cycleCount(), kNone);
        for (std::uint32_t cycle = 0; cycle < cycleCount(); ++cycle) m_partOf[cycle] = parts.rootOf(cycle);
        std::size_t points = 0;
        for (std::uint32_t point = 0; point + 1 < m_begins.size(); ++point) {
            if (m_begins[point] == m_begins[point + 1]) continue;
            ++points;
            std::uint32_t& leftmost = m_leftmost[m_partOf[m_cycleOf[m_around[m_begins[point]]]]];
            if (leftmost == kNone || isSmaller(at(point), at(leftmost))) leftmost = point;
        }
        m_isOuter.assign(cycleCount(), false);
        std::size_t count = 0;
        for (std::uint32_t part = 0; part < cycleCount(); ++part) {
            if (m_leftmost[part] == kNone) continue;
            // All its edges run to the right: what lies on its left is behind the last of them.
            m_isOuter[m_cycleOf[m_around[m_begins[m_leftmost[part] + 1] - 1]]] = true;
            ++count;
        }
        return points + cycleCount() == m_faces.edges.size() + 2 * count;
    }

    /// Numbers faces by their outer cycles, and puts each part as a hole into the face it lies in. False where cancelled.
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
        std::vector<std::uint32_t> behind(cycleCount(),
                                          kNone);  // of each outer cycle: one of the face that its part lies in
        for (const std::uint32_t cycle : outer) {
            if (m_task.isCancelled()) return false;
            if (outer.size() > 1) behind[cycle] = cycleLeftOf(m_leftmost[m_partOf[cycle]], m_partOf[cycle]);
        }
        for (const std::uint32_t cycle : outer) {
            std::uint32_t around = cycle;
            while (around != kNone && m_isOuter[around]) around = behind[around];
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
        std::vector<std::uint32_t> places(m_faces.ringsBegin.begin(), m_faces.ringsBegin.end() - 1);
        for (const bool isOuter : {false, true}) {
            for (std::uint32_t cycle = 0; cycle < cycleCount(); ++cycle) {
                if (m_isOuter[cycle] == isOuter) m_faces.rings[places[faceOfCycle[cycle]]++] = m_cycles[cycle];
            }
        }
    }

    /// The cycle of another part that a point sees when it looks to the left; kNone: nothing.
    std::uint32_t cycleLeftOf(std::uint32_t point, std::uint32_t part) const {
        const Vec2 from = at(point);
        std::uint32_t nearest = kNone;
        double best = 0.0;
        Vec2 nearestLow{}, nearestHigh{};
        for (std::uint32_t edge = 0; edge < m_faces.edges.size(); ++edge) {
            const bool isUp = at(m_faces.edges[edge].from).y < at(m_faces.edges[edge].to).y;
            const Vec2 low = at(m_faces.origin(2 * edge + (isUp ? 0 : 1))),
                       high = at(m_faces.origin(2 * edge + (isUp ? 1 : 0)));
            if (!(low.y <= from.y && from.y < high.y) || m_partOf[m_cycleOf[2 * edge]] == part) continue;
            if (orient2d(low, high, from) >= 0) continue;
            const double x = low.x + (high.x - low.x) * ((from.y - low.y) / (high.y - low.y));
            const bool isNearer = x > best || (x == best && orient2d(nearestLow, nearestHigh, high) < 0);
            if (nearest != kNone && !isNearer) continue;
            best = x, nearestLow = low, nearestHigh = high;
            nearest = 2 * edge + (isUp ? 1 : 0);  // runs down: its face lies on the right of the edge
        }
        return nearest == kNone ? kNone : m_cycleOf[nearest];
    }

    std::span<const Vec2> m_points;
    const TaskContext& m_task;
    PlaneFaces m_faces;
    std::vector<std::uint32_t> m_begins;    // of each point in m_around, and one more
    std::vector<std::uint32_t> m_around;    // half-edges
    std::vector<std::uint32_t> m_cycleOf;   // of each half-edge
    std::vector<std::uint32_t> m_cycles;    // a half-edge of each
    std::vector<std::uint32_t> m_partOf;    // of each cycle, the connected part, called by its first cycle
    std::vector<std::uint32_t> m_leftmost;  // point of each part
    std::vector<bool> m_isOuter;            // of each cycle
};

}  // namespace

Result<std::optional<PlaneFaces>> facesOf(const PlaneDrawing& drawing, const TaskContext& task) {
    return Tracing(drawing, task).run();
}

}  // namespace rubble
