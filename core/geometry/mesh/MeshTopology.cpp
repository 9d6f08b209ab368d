#include "core/geometry/mesh/MeshTopology.h"

#include "core/base/Index.h"
#include "core/base/Parallel.h"
#include "core/geometry/mesh/LatticeSigns.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rubble {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
constexpr std::size_t kBetweenLooks = 1u << 16;  // triangles between two looks at the cancellation

std::uint32_t originOf(const Triangles& triangles, std::uint32_t h) { return triangles[h / 3][h % 3]; }
std::uint32_t targetOf(const Triangles& triangles, std::uint32_t h) { return triangles[h / 3][(h % 3 + 1) % 3]; }
std::uint32_t apexOf(const Triangles& triangles, std::uint32_t h) { return triangles[h / 3][(h % 3 + 2) % 3]; }

/// Half-edges by the lower one of their points.
class EdgesByPoint {
public:
    /// Unfinished where cancelled.
    EdgesByPoint(const Triangles& triangles, std::size_t pointCount, const CancelToken& cancel)
        : m_first(pointCount + 1, 0) {
        const auto count = static_cast<std::uint32_t>(3 * triangles.size());
        for (std::uint32_t h = 0; h < count; ++h) {
            if (h % kBetweenLooks == 0 && cancel.isCancelled()) return;
            ++m_first[std::min(originOf(triangles, h), targetOf(triangles, h)) + 1];
        }
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
        m_edges.resize(count);
        std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
        for (std::uint32_t h = 0; h < count; ++h) {
            if (h % kBetweenLooks == 0 && cancel.isCancelled()) return;
            const std::uint32_t from = originOf(triangles, h), to = targetOf(triangles, h);
            m_edges[next[std::min(from, to)]++] = {std::max(from, to), h};
        }
    }

    struct Edge {
        std::uint32_t high, halfEdge;
        auto operator<=>(const Edge&) const = default;
    };
    std::span<Edge> of(std::size_t point) {
        return std::span(m_edges).subspan(m_first[point], m_first[point + 1] - m_first[point]);
    }

private:
    std::vector<std::uint32_t> m_first;
    std::vector<Edge> m_edges;
};

/// Pairs the half-edges of one edge; false if that cannot be done.
class EdgePairing {
public:
    EdgePairing(const Triangles& triangles, const std::vector<Vec3>& points, bool areInverted,
                std::vector<std::uint32_t>& across)
        : m_triangles(triangles), m_points(points), m_areInverted(areInverted), m_across(across) {}

    bool pair(std::span<const EdgesByPoint::Edge> edges) const {
        if (edges.size() % 2 != 0) return false;
        if (edges.size() == 2) {
            connect(edges[0].halfEdge, edges[1].halfEdge);
            return true;
        }
        return pairAround(edges);
    }

private:
    struct Leaf {
        std::uint32_t halfEdge;
        Vec3 apex;
        bool opensSolid;  // behind it, counter-clockwise
    };

    void connect(std::uint32_t a, std::uint32_t b) const { m_across[a] = b, m_across[b] = a; }

    bool pairAround(std::span<const EdgesByPoint::Edge> edges) const {
        std::vector<Leaf> leaves;
        std::uint32_t low = 0;
        for (const auto& [high, h] : edges) {
            const bool isAscending = targetOf(m_triangles, h) == high;
            low = isAscending ? originOf(m_triangles, h) : targetOf(m_triangles, h);
            leaves.push_back({h, m_points[apexOf(m_triangles, h)], isAscending == m_areInverted});
        }
        const Vec3 p = m_points[low], q = m_points[edges[0].high];
        if (std::ranges::any_of(leaves, [&](const Leaf& leaf) { return areCollinear(p, q, leaf.apex); })) return false;
        const AngleAround angles(p, q, leaves[0].apex);
        std::ranges::sort(leaves, [&](const Leaf& a, const Leaf& b) {
            const int order = angles.compare(a.apex, b.apex);
            return order != 0 ? order < 0 : std::tie(a.opensSolid, a.halfEdge) < std::tie(b.opensSolid, b.halfEdge);
        });
        for (std::size_t k = 0; k < leaves.size(); ++k) {
            if (leaves[k].opensSolid == leaves[(k + 1) % leaves.size()].opensSolid) return false;
        }
        for (std::size_t k = 0; k < leaves.size(); ++k) {
            if (leaves[k].opensSolid) connect(leaves[k].halfEdge, leaves[(k + 1) % leaves.size()].halfEdge);
        }
        return true;
    }

    const Triangles& m_triangles;
    const std::vector<Vec3>& m_points;
    bool m_areInverted;
    std::vector<std::uint32_t>& m_across;
};

}  // namespace

Result<EdgePairs> pairEdges(const Triangles& triangles, const std::vector<Vec3>& onLattice, bool areInverted,
                            const TaskContext& task) {
    constexpr std::size_t kChunkSize = 1u << 14;  // points
    EdgePairs result;
    result.across.assign(3 * triangles.size(), kNone);
    EdgesByPoint byPoint(triangles, onLattice.size(), task.cancel);
    if (task.isCancelled()) return TaskContext::cancelled();
    const EdgePairing pairing(triangles, onLattice, areInverted, result.across);
    std::vector<EdgePairs> parts(onLattice.size() / kChunkSize + 1);
    forEachIndex(parts.size(), task.threads, [&](std::size_t chunk) {
        if (task.isCancelled()) return;
        const IndexRange range = chunkRange(onLattice.size(), chunk, parts.size());
        EdgePairs& part = parts[chunk];
        for (std::size_t point = range.begin; point < range.end; ++point) {
            const std::span<EdgesByPoint::Edge> edges = byPoint.of(point);
            std::ranges::sort(edges);
            for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
                while (end < edges.size() && edges[end].high == edges[begin].high) ++end;
                const bool isPaired = pairing.pair(edges.subspan(begin, end - begin));
                if (!isPaired) (end - begin == 1 ? part.open : part.crowded).push_back(edges[begin].halfEdge);
                if (isPaired && end - begin > 2) part.divided.push_back(edges[begin].halfEdge);
            }
        }
    });
    if (task.isCancelled()) return TaskContext::cancelled();
    for (const EdgePairs& part : parts) {
        for (const auto list : {&EdgePairs::open, &EdgePairs::crowded, &EdgePairs::divided})
            (result.*list).insert((result.*list).end(), (part.*list).begin(), (part.*list).end());
    }
    for (const auto list : {&EdgePairs::open, &EdgePairs::crowded, &EdgePairs::divided})
        std::ranges::sort(result.*list);
    return result;
}

Result<Windings> agreeWindings(const Triangles& triangles, const std::vector<std::uint32_t>& across,
                               const TaskContext& task) {
    Windings result;
    const auto count = static_cast<std::uint32_t>(triangles.size());
    result.turned.assign(count, 0);
    result.shellOf.assign(count, kNone);
    std::vector<std::uint32_t> shell;  // its triangles, in the order in which they are reached
    std::size_t seen = 0;
    for (std::uint32_t first = 0; first < count; ++first) {
        if (result.shellOf[first] != kNone) continue;
        shell.assign(1, first);
        result.shellOf[first] = result.shellCount;
        std::size_t turned = 0;
        for (std::size_t k = 0; k < shell.size(); ++k) {
            if (++seen % kBetweenLooks == 0 && task.isCancelled()) return TaskContext::cancelled();
            const std::uint32_t triangle = shell[k];
            turned += static_cast<std::size_t>(result.turned[triangle]);
            for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
                const std::uint32_t next = across[h] / 3;
                const bool isSameDirection = originOf(triangles, h) == originOf(triangles, across[h]);
                const char turn = result.turned[triangle] ^ static_cast<char>(isSameDirection);
                if (result.shellOf[next] == kNone) {
                    result.shellOf[next] = result.shellCount;
                    result.turned[next] = turn;
                    shell.push_back(next);
                } else if (result.turned[next] != turn && h < across[h]) {
                    result.conflicting.push_back(h);
                }
            }
        }
        if (2 * turned > shell.size()) {
            for (const std::uint32_t triangle : shell) result.turned[triangle] ^= 1;
        }
        ++result.shellCount;
    }
    std::ranges::sort(result.conflicting);
    return result;
}

Result<SeparatedPoints> separateFans(const LatticeSurface& surface, const TaskContext& task) {
    SeparatedPoints result{surface.triangles, {}};
    const auto corners = static_cast<std::uint32_t>(3 * surface.triangles.size());
    std::vector<char> isSeen(corners, 0), isUsed(surface.points.size(), 0);
    for (std::uint32_t first = 0; first < corners; ++first) {
        if (first % kBetweenLooks == 0 && task.isCancelled()) return TaskContext::cancelled();
        if (isSeen[first]) continue;
        std::uint32_t point = surface.origin(first);
        const bool isCopy = isUsed[point];
        isUsed[point] = 1;
        if (isCopy) {
            result.copied.push_back(point);
            point = static_cast<std::uint32_t>(surface.points.size() + result.copied.size() - 1);
        }
        for (std::uint32_t h = first; !isSeen[h];) {
            isSeen[h] = 1;
            result.triangles[h / 3][h % 3] = point;
            const std::uint32_t over = surface.across[h];
            h = over / 3 * 3 + (over % 3 + 1) % 3;
        }
    }
    return result;
}

}  // namespace rubble
