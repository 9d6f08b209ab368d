#include "core/fracture/cuts/PlanarGraph.h"

#include "core/fracture/cuts/EdgeGrid.h"
#include "core/geometry/predicates/Predicates.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <span>

namespace rubble {
namespace {

/// Each round handles the edges that the previous one has bent, which are rare. Where points are about the weld
/// distance apart, welding two may bring others as close, again and again: then the distance grows from round to round.
constexpr int kMaxRounds = 12;
constexpr int kRoundsBeforeGrowth = 4;
constexpr double kWeldGrowth = 1.5;

/// A point at which an edge is split.
struct Node {
    std::uint32_t edge;
    std::uint32_t point;
    double along;  // distance along the edge, times its length
};

/// The intersection of two edges that cross. The coordinate of a horizontal or vertical edge is kept exactly.
Vec2 intersectionOf(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 first = b - a, second = d - c;
    const double fraction = std::clamp(cross(c - a, second) / cross(first, second), 0.0, 1.0);
    Vec2 point = a + fraction * first;
    for (const int axis : {0, 1}) {
        if (first[axis] == 0.0) point[axis] = a[axis];
        if (second[axis] == 0.0) point[axis] = c[axis];
    }
    return point;
}

class IntersectionSplitter {
public:
    IntersectionSplitter(const AcuteCorners& acuteCorners, const TaskContext& task, PlanarGraph& graph)
        : m_acuteCorners(acuteCorners), m_task(task), m_graph(graph), m_frame(graph.frame) {}

    Status run() {
        insertAllButLargestGroup();
        for (int round = 0; round < kMaxRounds; ++round) {
            if (const Status found = findIntersections(); !found) return found;
            splitEdges();
            weldPoints();
            if (m_inserted.empty()) {
                std::erase_if(m_graph.edges, [](const PlanarEdge& edge) { return edge.from == edge.to; });
                return success();
            }
            m_isFirst = false;
            if (round + 1 >= kRoundsBeforeGrowth) m_frame.weldDistance *= kWeldGrowth;
        }
        return Error{ErrorCode::Degenerate, "Cuts of the pattern are too close together to be distinguished."};
    }

private:
    Vec2 at(std::uint32_t point) const { return m_graph.points[point]; }
    EdgeGrid::Edge lineOf(const PlanarEdge& edge) const { return {at(edge.from), at(edge.to)}; }

    /// At first all edges are compared with all but those of the largest noded group.
    void insertAllButLargestGroup() {
        std::vector<std::size_t> sizes(m_graph.isNodedGroup.size(), 0);
        for (const PlanarEdge& edge : m_graph.edges) ++sizes[edge.group];
        std::uint32_t largest = kNone;
        for (std::uint32_t group = 0; group < sizes.size(); ++group) {
            if (m_graph.isNodedGroup[group] && (largest == kNone || sizes[group] > sizes[largest])) largest = group;
        }
        for (std::uint32_t edge = 0; edge < m_graph.edges.size(); ++edge) {
            if (m_graph.edges[edge].group != largest) m_inserted.push_back(edge);
        }
    }

    /// Compares every edge with those of m_inserted.
    Status findIntersections() {
        std::vector<EdgeGrid::Edge> lines;
        lines.reserve(m_inserted.size());
        for (const std::uint32_t edge : m_inserted) lines.push_back(lineOf(m_graph.edges[edge]));
        const EdgeGrid grid(lines, m_frame.weldDistance);
        std::vector<std::uint32_t> insertedIndexOf(m_graph.edges.size(), kNone),
            lastComparedWith(m_inserted.size(), kNone);
        for (std::uint32_t k = 0; k < m_inserted.size(); ++k) insertedIndexOf[m_inserted[k]] = k;
        std::size_t compared = 0;
        bool isCancelled = false;
        for (std::uint32_t edge = 0; edge < m_graph.edges.size() && !isCancelled; ++edge) {
            if (edge % 1024 == 0 && m_task.isCancelled()) return TaskContext::cancelled();
            if (isTooLarge()) break;
            const std::uint32_t own = insertedIndexOf[edge];
            grid.forEachNear(lineOf(m_graph.edges[edge]), [&](std::uint32_t other) {
                if (isTooLarge() || lastComparedWith[other] == edge || other == own || (own != kNone && other < own))
                    return;
                lastComparedWith[other] = edge;
                if (++compared % 65536 == 0) isCancelled = isCancelled || m_task.isCancelled();
                compare(edge, m_inserted[other]);
            });
        }
        if (isTooLarge()) {
            return Error{ErrorCode::Limit, "Cuts of the pattern cross each other, cells and the outline in more than " +
                                               std::to_string(kMaxIntersections) +
                                               " places. Use fewer cuts, fewer seeds or a simpler outline."};
        }
        return isCancelled ? Status(TaskContext::cancelled()) : success();
    }
    bool isTooLarge() const { return m_nodes.size() > 2 * kMaxIntersections; }  // two edges meet in each

    void compare(std::uint32_t first, std::uint32_t second) {
        const PlanarEdge& one = m_graph.edges[first];
        const PlanarEdge& other = m_graph.edges[second];
        if (m_isFirst && one.group == other.group && m_graph.isNodedGroup[one.group]) return;
        const Vec2 a = at(one.from), b = at(one.to), c = at(other.from), d = at(other.to);
        const double margin = m_frame.weldDistance;
        if (std::max(a.x, b.x) + margin < std::min(c.x, d.x) || std::max(c.x, d.x) + margin < std::min(a.x, b.x) ||
            std::max(a.y, b.y) + margin < std::min(c.y, d.y) || std::max(c.y, d.y) + margin < std::min(a.y, b.y)) {
            return;
        }
        bool isTouching = touchesAt(one.from, second);
        isTouching = touchesAt(one.to, second) || isTouching;
        isTouching = touchesAt(other.from, first) || isTouching;
        isTouching = touchesAt(other.to, first) || isTouching;
        if (isTouching) return;
        if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0)
            addCrossing(first, second);
    }

    /// Whether a point lies on an edge, within the weld distance. Notes the weld or the node.
    bool touchesAt(std::uint32_t point, std::uint32_t number) {
        const PlanarEdge& edge = m_graph.edges[number];
        if (point == edge.from || point == edge.to) return true;
        const Vec2 from = at(edge.from), along = at(edge.to) - from, offset = at(point) - from;
        for (const std::uint32_t end : {edge.from, edge.to}) {
            if (!m_frame.coincide(at(point), at(end)) && !isInAcuteCorner(edge, end, at(point))) continue;
            m_welds.push_back({point, end});
            return true;
        }
        const double squared = glm::dot(along, along), place = glm::dot(along, offset), apart = cross(along, offset);
        if (place <= 0.0 || place >= squared) return false;
        if (apart * apart > m_frame.weldDistance * m_frame.weldDistance * squared) return false;
        m_nodes.push_back({number, point, place});
        return true;
    }

    void addCrossing(std::uint32_t first, std::uint32_t second) {
        const PlanarEdge one = m_graph.edges[first], other = m_graph.edges[second];
        const Vec2 where = intersectionOf(at(one.from), at(one.to), at(other.from), at(other.to));
        if (const std::uint32_t corner = acuteCornerAt(one, where); corner != kNone) return addNode(second, corner);
        if (const std::uint32_t corner = acuteCornerAt(other, where); corner != kNone) return addNode(first, corner);
        const auto point = static_cast<std::uint32_t>(m_graph.points.size());
        m_graph.points.push_back(where);
        addNode(first, point);
        addNode(second, point);
    }

    void addNode(std::uint32_t edge, std::uint32_t point) {
        const Vec2 from = at(m_graph.edges[edge].from);
        m_nodes.push_back({edge, point, glm::dot(at(m_graph.edges[edge].to) - from, at(point) - from)});
    }

    /// The end of an outline edge whose acute corner region contains a point; kNone: neither.
    std::uint32_t acuteCornerAt(const PlanarEdge& edge, Vec2 where) const {
        for (const std::uint32_t end : {edge.from, edge.to}) {
            if (isInAcuteCorner(edge, end, where)) return end;
        }
        return kNone;
    }
    bool isInAcuteCorner(const PlanarEdge& edge, std::uint32_t end, Vec2 where) const {
        if (m_acuteCorners.isEmpty() || edge.group != 0 || (edge.left != kNone && edge.right != kNone)) return false;
        const std::uint32_t vertex = m_graph.vertexOf(end);
        return vertex != kNone && m_acuteCorners.contain(vertex, where);
    }

    /// Replaces edges that have nodes by edges from node to node. Those that are bent by it are compared with all
    /// others again.
    void splitEdges() {
        m_inserted.clear();
        // Counting sort by edge: the nodes of each edge are mostly in order then.
        const auto edges = static_cast<std::uint32_t>(m_graph.edges.size());
        std::vector<std::uint32_t> ends(edges + 1, 0);
        for (const Node& node : m_nodes) ++ends[node.edge + 1];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<Node> sorted(m_nodes.size());
        for (const Node& node : m_nodes) sorted[ends[node.edge]++] = node;
        const auto isBefore = [](const Node& a, const Node& b) {
            return a.along != b.along ? a.along < b.along : a.point < b.point;
        };
        for (std::uint32_t edge = 0, begin = 0; edge < edges; begin = ends[edge++]) {
            const std::span nodes(sorted.data() + begin, ends[edge] - begin);
            if (nodes.empty()) continue;
            if (!std::ranges::is_sorted(nodes, isBefore)) std::ranges::sort(nodes, isBefore);
            splitEdge(edge, nodes);
        }
        m_nodes.clear();
        m_firstNew = static_cast<std::uint32_t>(m_graph.points.size());
    }

    void splitEdge(std::uint32_t number, std::span<const Node> nodes) {
        const PlanarEdge whole = m_graph.edges[number];
        const bool isBent = std::ranges::any_of(nodes, [&](const Node& node) {
            return node.point < m_firstNew && orient2d(at(whole.from), at(whole.to), at(node.point)) != 0;
        });
        PlanarEdge edge = whole;
        std::uint32_t place = number;
        const auto append = [&](std::uint32_t to) {
            if (edge.from == to) return;
            if (m_frame.coincide(at(edge.from), at(to))) m_welds.push_back({edge.from, to});
            edge.to = to;
            if (isBent) m_inserted.push_back(place);
            m_graph.edges[place] = edge;
            edge.from = to;
            place = static_cast<std::uint32_t>(m_graph.edges.size());
            m_graph.edges.emplace_back();
        };
        for (const Node& node : nodes) append(node.point);
        append(whole.to);
        m_graph.edges.pop_back();
    }

    /// Replaces welded points in all edges.
    void weldPoints() {
        if (m_welds.empty()) return;
        std::map<std::uint32_t, std::uint32_t>
            weldedTo;  // each point but the representative, to the next one on the way to it
        std::vector<bool> isMoved(m_graph.points.size(), false);
        const auto rootOf = [&](std::uint32_t point) {
            for (auto next = weldedTo.find(point); next != weldedTo.end(); next = weldedTo.find(point))
                point = next->second;
            return point;
        };
        for (const auto& weld : m_welds) {
            std::uint32_t stays = rootOf(weld[0]), goes = rootOf(weld[1]);
            if (stays == goes) continue;
            if (isCorner(goes) || (!isCorner(stays) && goes < stays)) std::swap(stays, goes);
            if (isCorner(goes)) continue;
            weldedTo[goes] = stays;
        }
        for (const auto& [goes, to] : weldedTo) isMoved[goes] = true;
        m_welds.clear();
        std::vector<bool> isInserted(m_graph.edges.size(), false);
        for (const std::uint32_t edge : m_inserted) isInserted[edge] = true;
        for (std::uint32_t number = 0; number < m_graph.edges.size(); ++number) {
            PlanarEdge& edge = m_graph.edges[number];
            bool isChanged = false;
            for (std::uint32_t* end : {&edge.from, &edge.to}) {
                if (!isMoved[*end]) continue;
                const std::uint32_t stays = rootOf(*end);
                isChanged = isChanged || at(*end) != at(stays);
                *end = stays;
            }
            if (isChanged && !isInserted[number]) m_inserted.push_back(number);
        }
        std::erase_if(m_inserted,
                      [&](std::uint32_t edge) { return m_graph.edges[edge].from == m_graph.edges[edge].to; });
    }
    bool isCorner(std::uint32_t point) const { return m_graph.vertexOf(point) != kNone; }

    const AcuteCorners& m_acuteCorners;
    const TaskContext& m_task;
    PlanarGraph& m_graph;
    LocalFrame m_frame;
    bool m_isFirst = true;
    std::uint32_t m_firstNew = static_cast<std::uint32_t>(m_graph.points.size());
    std::vector<std::uint32_t> m_inserted;  // edges that all others are compared with
    std::vector<Node> m_nodes;
    std::vector<std::array<std::uint32_t, 2>> m_welds;  // points
};

}  // namespace

Status splitAtIntersections(const AcuteCorners& acuteCorners, const TaskContext& task, PlanarGraph& graph) {
    return IntersectionSplitter(acuteCorners, task, graph).run();
}

}  // namespace rubble
