#include "core/fracture/solid/SolidShells.h"

#include "core/base/DisjointSets.h"
#include "core/base/Groups.h"
#include "core/base/Parallel.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace rubble {
namespace {

class ShellBuilder {
public:
    ShellBuilder(const SolidFaces& faces, std::span<const Vec3> points, const TaskContext& task)
        : m_faces(faces), m_points(points), m_task(task) {}

    Result<SolidShells> build() {
        groupEdges();
        DisjointSets sets = joinedSides();
        if (m_task.isCancelled()) return TaskContext::cancelled();
        numberShells(sets);
        forEachIndex(m_result.shells.size(), m_task.threads, [this](std::size_t shell) {
            if (!m_task.isCancelled()) measure(m_result.shells[shell]);
        });
        if (m_task.isCancelled()) return TaskContext::cancelled();
        assignCavities();
        dissolveThinShells();
        return std::move(m_result);
    }

private:
    /// An edge of a side of a face, for finding the side that continues its shell.
    struct SideEdge {
        std::uint32_t high;  // the point of its ends with the higher number
        std::uint32_t cell;
        std::uint32_t direction;  // 2 * side, + 1 if it runs to `high`, seen from outside the cell

        std::uint32_t side() const { return direction / 2; }  // 2 * face, + 1 if from behind
        bool isForward() const { return direction % 2 == 1; }
        bool isBeside(const SideEdge& other) const { return high == other.high && cell == other.cell; }
        auto operator<=>(const SideEdge&) const = default;
    };

    Vec3 outwardNormal(std::uint32_t side) const {
        Vec3 normal(0.0);
        for (const std::array<std::uint32_t, 3>& t : m_faces.trianglesOf(side / 2)) {
            normal += glm::cross(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]]);
        }
        return side % 2 == 0 ? normal : -normal;
    }

    /// A side at an edge, by the angle at which it leaves the edge.
    struct SideAround {
        double angle = 0.0;
        bool isForward = false;
        std::uint32_t side = 0;
    };

    /// Sorts sides around an edge, from the one after the widest gap on. Of sides that coincide, those that run forward
    /// come first: between the ones and the others there is nothing.
    static void sortAround(std::vector<SideAround>& around) {
        constexpr double kMinAngle = 1e-6;  // smaller ones are rounding
        std::ranges::sort(around, [](const SideAround& a, const SideAround& b) {
            return a.angle != b.angle ? a.angle < b.angle : a.side < b.side;
        });
        std::size_t start = 0;
        double widest = around.front().angle + 2.0 * std::numbers::pi - around.back().angle;
        for (std::size_t k = 1; k < around.size(); ++k) {
            const double gap = around[k].angle - around[k - 1].angle;
            if (gap > widest) widest = gap, start = k;
        }
        std::ranges::rotate(around, around.begin() + static_cast<std::ptrdiff_t>(start));
        const auto gapAfter = [](const SideAround& a, const SideAround& b) {
            const double gap = b.angle - a.angle;
            return gap < 0.0 ? gap + 2.0 * std::numbers::pi : gap;
        };
        for (auto begin = around.begin(); begin != around.end();) {
            auto end = begin + 1;
            while (end != around.end() && gapAfter(*(end - 1), *end) < kMinAngle) ++end;
            std::stable_partition(begin, end, [](const SideAround& side) { return side.isForward; });
            begin = end;
        }
    }

    /// Joins the sides at an edge: where there are more than two, those that have their cell between them.
    void joinAround(std::uint32_t low, std::span<const SideEdge> edges, DisjointSets& sets) const {
        if (edges.size() == 2) return join(edges[0].side(), edges[1].side(), sets);
        const Vec3 along = glm::normalize(m_points[edges[0].high] - m_points[low]);
        std::vector<SideAround> around;
        Vec3 right(0.0), up(0.0);
        for (const SideEdge& edge : edges) {
            const Vec3 inward = glm::cross(outwardNormal(edge.side()), edge.isForward() ? along : -along);
            if (around.empty()) right = glm::normalize(inward), up = glm::cross(along, right);
            around.push_back(
                {std::atan2(glm::dot(inward, up), glm::dot(inward, right)), edge.isForward(), edge.side()});
        }
        sortAround(around);
        // The cell is after a side that runs backward, and before one that runs forward.
        for (std::size_t k = 0; k < around.size(); ++k) {
            const SideAround& next = around[(k + 1) % around.size()];
            if (!around[k].isForward && next.isForward) join(around[k].side, next.side, sets);
        }
    }

    /// Groups the edges of all sides by the point of their ends with the lower number.
    void groupEdges() {
        const std::size_t parts = groupingParts(m_task.threads);
        m_edges = grouped<SideEdge>(m_points.size(), parts, m_task.threads, [&](std::size_t part, const auto& visit) {
            const IndexRange range = chunkRange(m_faces.faceCount(), part, parts);
            for (std::size_t k = range.begin; k < range.end && !m_task.isCancelled(); ++k) {
                const std::uint32_t f = static_cast<std::uint32_t>(k);
                const SolidPartition::Face& face = m_faces.faces[f];
                for (std::uint32_t l = m_faces.firstLoop[f]; l < m_faces.firstLoop[f + 1]; ++l) {
                    const std::span<const std::uint32_t> loop = m_faces.loop(l);
                    std::uint32_t a = loop.back();
                    for (const std::uint32_t b : loop) {
                        const auto [low, high] = std::minmax(a, b);
                        visit(low, SideEdge{high, face.fragment, 4 * f + (a < b ? 1 : 0)});
                        if (face.behind != kNone) visit(low, SideEdge{high, face.behind, 4 * f + 2 + (a < b ? 0 : 1)});
                        a = b;
                    }
                }
            }
        });
    }

    /// The sides of faces, joined to shells.
    DisjointSets joinedSides() {
        constexpr std::size_t kChunk = 1024;  // points
        DisjointSets sets(2 * m_faces.faceCount());
        forEachIndex((m_points.size() + kChunk - 1) / kChunk, m_task.threads, [&](std::size_t chunk) {
            const std::size_t last = std::min((chunk + 1) * kChunk, m_points.size());
            for (std::size_t low = chunk * kChunk; low < last && !m_task.isCancelled(); ++low) {
                const std::span<SideEdge> edges = m_edges.of(low);
                std::ranges::sort(edges);
                for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
                    while (end < edges.size() && edges[end].isBeside(edges[begin])) ++end;
                    joinAround(static_cast<std::uint32_t>(low), edges.subspan(begin, end - begin), sets);
                }
            }
        });
        return sets;
    }

    void join(std::uint32_t a, std::uint32_t b, DisjointSets& sets) const {
        m_task.threads > 1 ? sets.mergeShared(a, b) : sets.merge(a, b);
    }

    void numberShells(DisjointSets& sets) {
        std::vector<std::uint32_t> shellOfRoot(sets.count(), kNone);
        m_result.ofSide.assign(sets.count(), kNone);
        const auto enter = [&](std::uint32_t side, std::uint32_t cell) {
            std::uint32_t& shell = shellOfRoot[sets.rootOf(side)];
            if (shell == kNone) {
                shell = static_cast<std::uint32_t>(m_result.shells.size());
                m_result.shells.push_back({.cell = cell, .owner = shell, .sides = {}});
            }
            m_result.shells[shell].sides.push_back(side);
            m_result.ofSide[side] = shell;
        };
        for (std::uint32_t f = 0; f < m_faces.faceCount(); ++f) {
            const SolidPartition::Face& face = m_faces.faces[f];
            enter(2 * f, face.fragment);
            if (face.behind != kNone) enter(2 * f + 1, face.behind);
        }
    }

    template <class Visit>
    void forEachTriangle(const SolidShell& shell, const Visit& visit) const {
        for (const std::uint32_t side : shell.sides) {
            for (const std::array<std::uint32_t, 3>& t : m_faces.trianglesOf(side / 2)) {
                side % 2 == 0 ? visit(t[0], t[1], t[2]) : visit(t[0], t[2], t[1]);
            }
        }
    }

    void measure(SolidShell& shell) const {
        const Vec3 origin = m_points[m_faces.trianglesOf(shell.sides[0] / 2)[0][0]];
        forEachTriangle(shell, [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
            shell.volume +=
                glm::dot(m_points[a] - origin, glm::cross(m_points[b] - origin, m_points[c] - origin)) / 6.0;
            shell.area += glm::length(glm::cross(m_points[b] - m_points[a], m_points[c] - m_points[a])) / 2.0;
            for (const std::uint32_t point : {a, b, c}) {
                if (shell.smallest == kNone || lexicographicLess(m_points[point], m_points[shell.smallest])) {
                    shell.smallest = point;
                }
            }
        });
    }

    static bool isThinShell(const SolidShell& shell) { return std::abs(shell.volume) <= kTieDistance * shell.area; }

    /// How often a shell goes around a point: 1 inside, 0 outside.
    /// Source: Van Oosterom, Strackee, The solid angle of a plane triangle, 1983.
    double windingNumber(const SolidShell& shell, Vec3 point) const {
        double angle = 0.0;
        forEachTriangle(shell, [&](std::uint32_t ia, std::uint32_t ib, std::uint32_t ic) {
            const Vec3 a = m_points[ia] - point, b = m_points[ib] - point, c = m_points[ic] - point;
            const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
            const double scale = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
            angle += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)), scale);
        });
        return angle / (4.0 * 3.14159265358979323846);
    }

    void assignCavities() {
        std::map<std::uint32_t, std::vector<std::uint32_t>> outsides;  // of each cell
        for (std::uint32_t s = 0; s < m_result.shells.size(); ++s) {
            if (m_result.shells[s].volume > 0.0 && !isThinShell(m_result.shells[s]))
                outsides[m_result.shells[s].cell].push_back(s);
        }
        for (SolidShell& cavity : m_result.shells) {
            if (cavity.volume > 0.0 || isThinShell(cavity)) continue;
            double most = -1.0;
            const std::vector<std::uint32_t>& around = outsides[cavity.cell];
            for (const std::uint32_t s : around) {
                const double number =
                    around.size() == 1 ? 1.0 : windingNumber(m_result.shells[s], m_points[cavity.smallest]);
                if (number > most) most = number, cavity.owner = s;
            }
        }
    }

    double areaOf(std::uint32_t face) const {
        double area = 0.0;
        for (const std::array<std::uint32_t, 3>& t : m_faces.trianglesOf(face)) {
            area += glm::length(glm::cross(m_points[t[1]] - m_points[t[0]], m_points[t[2]] - m_points[t[0]])) / 2.0;
        }
        return area;
    }

    /// Gives shells of no thickness to the neighbour with the largest common face, from fragments inward: one that has
    /// only such neighbours waits for them. What has no others is left out.
    void dissolveThinShells() {
        std::vector<std::uint32_t> thin;
        std::vector<bool> isWaiting(m_result.shells.size());
        for (std::uint32_t s = 0; s < m_result.shells.size(); ++s) {
            if (!isThinShell(m_result.shells[s])) continue;
            thin.push_back(s);
            isWaiting[s] = true;
        }
        for (bool isChanged = true; isChanged;) {
            isChanged = false;
            for (const std::uint32_t s : thin) {
                const std::uint32_t receiver = isWaiting[s] ? receiverOf(s, isWaiting) : kNone;
                if (receiver == kNone) continue;
                m_result.shells[s].owner = receiver;
                isWaiting[s] = false;
                isChanged = true;
            }
        }
        for (const std::uint32_t s : thin) {
            if (isWaiting[s]) m_result.shells[s].owner = kNone;
        }
    }

    /// The neighbour of a shell with the largest common face that is not waiting itself.
    std::uint32_t receiverOf(std::uint32_t shell, const std::vector<bool>& isWaiting) const {
        double largest = -1.0;
        std::uint32_t receiver = kNone;
        for (const std::uint32_t side : m_result.shells[shell].sides) {
            const std::uint32_t other = m_result.ofSide[side ^ 1];
            if (other == kNone || isWaiting[other]) continue;
            const double area = areaOf(side / 2);
            if (area > largest) largest = area, receiver = m_result.ownerOf(other);
        }
        return receiver;
    }

    const SolidFaces& m_faces;
    std::span<const Vec3> m_points;
    const TaskContext& m_task;
    Groups<SideEdge> m_edges;  // by their lower point
    SolidShells m_result;
};

}  // namespace

Result<SolidShells> solidShells(const SolidFaces& faces, std::span<const Vec3> points, const TaskContext& task) {
    return ShellBuilder(faces, points, task).build();
}

}  // namespace rubble
