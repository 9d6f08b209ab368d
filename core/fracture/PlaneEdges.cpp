#include "core/fracture/PlaneEdges.h"

#include "core/fracture/EdgeGrid.h"
#include "core/geometry/Predicates.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <numeric>
#include <span>

namespace rubble {
namespace {

/// Each round deals with what the one before has moved, which is hardly ever anything. Where points lie as far apart as what is
/// joined, moving one may bring others as near, on and on: then more is joined from round to round.
constexpr int kMostRounds = 12;
constexpr int kPatientRounds = 4;
constexpr double kMoreJoined = 1.5;

/// A point that an edge goes through.
struct Node {
    std::uint32_t edge;
    std::uint32_t point;
    double along;  // of the edge, times its length
};

/// Where two edges that cross do so. Coordinates that all points of one of them have are kept.
Vec2 crossingOf(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const Vec2 first = b - a, second = d - c;
    const double share = std::clamp(cross(c - a, second) / cross(first, second), 0.0, 1.0);
    Vec2 point = a + share * first;
    for (const int axis : {0, 1}) {
        if (first[axis] == 0.0) point[axis] = a[axis];
        if (second[axis] == 0.0) point[axis] = c[axis];
    }
    return point;
}

class Parting {
public:
    Parting(const OutlineTips& tips, const TaskContext& task, PlaneDrawing& drawing)
        : m_tips(tips), m_task(task), m_drawing(drawing), m_frame(drawing.frame) {}

    Status run() {
        takeAllButLargest();
        for (int round = 0; round < kMostRounds; ++round) {
            if (!findMeetings()) return TaskContext::cancelled();
            partEdges();
            joinPoints();
            if (m_inserted.empty()) {
                std::erase_if(m_drawing.edges, [](const PlaneEdge& edge) { return edge.from == edge.to; });
                return success();
            }
            m_isFirst = false;
            if (round + 1 >= kPatientRounds) m_frame.joinDistance *= kMoreJoined;
        }
        return Error{ErrorCode::Degenerate, "The cuts of the pattern meet in too narrow a place to be told apart."};
    }

private:
    Vec2 at(std::uint32_t point) const { return m_drawing.points[point]; }
    EdgeGrid::Edge lineOf(const PlaneEdge& edge) const { return {at(edge.from), at(edge.to)}; }

    /// At first all edges are compared with all but those of the largest group that is noded.
    void takeAllButLargest() {
        std::vector<std::size_t> sizes(m_drawing.isNodedGroup.size(), 0);
        for (const PlaneEdge& edge : m_drawing.edges) ++sizes[edge.group];
        std::uint32_t largest = kNone;
        for (std::uint32_t group = 0; group < sizes.size(); ++group) {
            if (m_drawing.isNodedGroup[group] && (largest == kNone || sizes[group] > sizes[largest])) largest = group;
        }
        for (std::uint32_t edge = 0; edge < m_drawing.edges.size(); ++edge) {
            if (m_drawing.edges[edge].group != largest) m_inserted.push_back(edge);
        }
    }

    /// Compares every edge with those of m_inserted. False where the task was cancelled.
    bool findMeetings() {
        std::vector<EdgeGrid::Edge> lines;
        lines.reserve(m_inserted.size());
        for (const std::uint32_t edge : m_inserted) lines.push_back(lineOf(m_drawing.edges[edge]));
        const EdgeGrid grid(lines, m_frame.joinDistance);
        std::vector<std::uint32_t> placeOf(m_drawing.edges.size(), kNone), askedFor(m_inserted.size(), kNone);
        for (std::uint32_t k = 0; k < m_inserted.size(); ++k) placeOf[m_inserted[k]] = k;
        std::size_t compared = 0;
        bool isCancelled = false;
        for (std::uint32_t edge = 0; edge < m_drawing.edges.size() && !isCancelled; ++edge) {
            if (edge % 1024 == 0 && m_task.isCancelled()) return false;
            const std::uint32_t own = placeOf[edge];
            grid.forEachNear(lineOf(m_drawing.edges[edge]), [&](std::uint32_t other) {
                if (askedFor[other] == edge || other == own || (own != kNone && other < own)) return;
                askedFor[other] = edge;
                if (++compared % 65536 == 0) isCancelled = isCancelled || m_task.isCancelled();
                compare(edge, m_inserted[other]);
            });
        }
        return !isCancelled;
    }

    void compare(std::uint32_t first, std::uint32_t second) {
        const PlaneEdge& one = m_drawing.edges[first];
        const PlaneEdge& other = m_drawing.edges[second];
        if (m_isFirst && one.group == other.group && m_drawing.isNodedGroup[one.group]) return;
        const Vec2 a = at(one.from), b = at(one.to), c = at(other.from), d = at(other.to);
        const double margin = m_frame.joinDistance;
        if (std::max(a.x, b.x) + margin < std::min(c.x, d.x) || std::max(c.x, d.x) + margin < std::min(a.x, b.x) ||
            std::max(a.y, b.y) + margin < std::min(c.y, d.y) || std::max(c.y, d.y) + margin < std::min(a.y, b.y)) {
            return;
        }
        bool isMet = meetsAt(one.from, second);
        isMet = meetsAt(one.to, second) || isMet;
        isMet = meetsAt(other.from, first) || isMet;
        isMet = meetsAt(other.to, first) || isMet;
        if (isMet) return;
        if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0)
            addCrossing(first, second);
    }

    /// Whether a point is so near to an edge that the edge goes through it; it then does.
    bool meetsAt(std::uint32_t point, std::uint32_t number) {
        const PlaneEdge& edge = m_drawing.edges[number];
        if (point == edge.from || point == edge.to) return true;
        const Vec2 from = at(edge.from), along = at(edge.to) - from, offset = at(point) - from;
        for (const std::uint32_t end : {edge.from, edge.to}) {
            if (!m_frame.areOne(at(point), at(end)) && !isInTip(edge, end, at(point))) continue;
            m_joins.push_back({point, end});
            return true;
        }
        const double squared = glm::dot(along, along), place = glm::dot(along, offset), apart = cross(along, offset);
        if (place <= 0.0 || place >= squared) return false;
        if (apart * apart > m_frame.joinDistance * m_frame.joinDistance * squared) return false;
        m_nodes.push_back({number, point, place});
        return true;
    }

    void addCrossing(std::uint32_t first, std::uint32_t second) {
        const PlaneEdge one = m_drawing.edges[first], other = m_drawing.edges[second];
        const Vec2 where = crossingOf(at(one.from), at(one.to), at(other.from), at(other.to));
        if (const std::uint32_t tip = tipAt(one, where); tip != kNone) return addNode(second, tip);
        if (const std::uint32_t tip = tipAt(other, where); tip != kNone) return addNode(first, tip);
        const auto point = static_cast<std::uint32_t>(m_drawing.points.size());
        m_drawing.points.push_back(where);
        addNode(first, point);
        addNode(second, point);
    }

    void addNode(std::uint32_t edge, std::uint32_t point) {
        const Vec2 from = at(m_drawing.edges[edge].from);
        m_nodes.push_back({edge, point, glm::dot(at(m_drawing.edges[edge].to) - from, at(point) - from)});
    }

    /// The end of an outline's edge whose sharp tip a place lies in; kNone: none.
    std::uint32_t tipAt(const PlaneEdge& edge, Vec2 where) const {
        for (const std::uint32_t end : {edge.from, edge.to}) {
            if (isInTip(edge, end, where)) return end;
        }
        return kNone;
    }
    bool isInTip(const PlaneEdge& edge, std::uint32_t end, Vec2 where) const {
        if (m_tips.areNone() || edge.group != 0 || (edge.left != kNone && edge.right != kNone)) return false;
        const std::uint32_t vertex = m_drawing.vertexOf(end);
        return vertex != kNone && m_tips.contain(vertex, where);
    }

    /// Puts edges from node to node in place of those that have nodes. Those that do not run as straight as before are compared
    /// with all others once more.
    void partEdges() {
        m_inserted.clear();
        // First by edge: along each of them the nodes mostly come in their order then.
        const auto edges = static_cast<std::uint32_t>(m_drawing.edges.size());
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
            part(edge, nodes);
        }
        m_nodes.clear();
        m_firstNew = static_cast<std::uint32_t>(m_drawing.points.size());
    }

    void part(std::uint32_t number, std::span<const Node> nodes) {
        const PlaneEdge whole = m_drawing.edges[number];
        const bool isBent = std::ranges::any_of(nodes, [&](const Node& node) {
            return node.point < m_firstNew && orient2d(at(whole.from), at(whole.to), at(node.point)) != 0;
        });
        PlaneEdge edge = whole;
        std::uint32_t place = number;
        const auto append = [&](std::uint32_t to) {
            if (edge.from == to) return;
            if (m_frame.areOne(at(edge.from), at(to))) m_joins.push_back({edge.from, to});
            edge.to = to;
            if (isBent) m_inserted.push_back(place);
            m_drawing.edges[place] = edge;
            edge.from = to;
            place = static_cast<std::uint32_t>(m_drawing.edges.size());
            m_drawing.edges.emplace_back();
        };
        for (const Node& node : nodes) append(node.point);
        append(whole.to);
        m_drawing.edges.pop_back();
    }

    /// Puts one point in place of several, in all edges.
    void joinPoints() {
        if (m_joins.empty()) return;
        std::map<std::uint32_t, std::uint32_t> joined;  // each but the one that stays, to one that is nearer to it
        std::vector<bool> isMoved(m_drawing.points.size(), false);
        const auto rootOf = [&](std::uint32_t point) {
            for (auto next = joined.find(point); next != joined.end(); next = joined.find(point)) point = next->second;
            return point;
        };
        for (const auto& join : m_joins) {
            std::uint32_t stays = rootOf(join[0]), goes = rootOf(join[1]);
            if (stays == goes) continue;
            if (isCorner(goes) || (!isCorner(stays) && goes < stays)) std::swap(stays, goes);
            if (isCorner(goes)) continue;
            joined[goes] = stays;
        }
        for (const auto& [goes, to] : joined) isMoved[goes] = true;
        m_joins.clear();
        std::vector<bool> isInserted(m_drawing.edges.size(), false);
        for (const std::uint32_t edge : m_inserted) isInserted[edge] = true;
        for (std::uint32_t number = 0; number < m_drawing.edges.size(); ++number) {
            PlaneEdge& edge = m_drawing.edges[number];
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
                      [&](std::uint32_t edge) { return m_drawing.edges[edge].from == m_drawing.edges[edge].to; });
    }
    bool isCorner(std::uint32_t point) const { return m_drawing.vertexOf(point) != kNone; }

    const OutlineTips& m_tips;
    const TaskContext& m_task;
    PlaneDrawing& m_drawing;
    PointFrame m_frame;
    bool m_isFirst = true;
    std::uint32_t m_firstNew = static_cast<std::uint32_t>(m_drawing.points.size());
    std::vector<std::uint32_t> m_inserted;  // edges that others are compared with
    std::vector<Node> m_nodes;
    std::vector<std::array<std::uint32_t, 2>> m_joins;  // points
};

}  // namespace

Status partAtMeetings(const OutlineTips& tips, const TaskContext& task, PlaneDrawing& drawing) {
    return Parting(tips, task, drawing).run();
}

}  // namespace rubble
