#include "core/geometry/mesh/MeshShells.h"

#include "core/base/Parallel.h"
#include "core/geometry/mesh/LatticeSigns.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace rubble {
namespace {

/// A shell around a point, and how often it goes around it.
struct Winding {
    std::uint32_t shell = 0;
    int number = 0;
};

/// Finds the shells around points. Points are in half steps, so that middles of edges are on the lattice, too.
class ShellsAround {
public:
    ShellsAround(const LatticeSurface& surface, const std::vector<std::uint32_t>& shellOf, const TriangleTree& tree)
        : m_surface(surface), m_shellOf(shellOf), m_tree(tree) {}

    /// The windings of shells but `own` around a point, by shell; nothing if the point is on one of them.
    std::optional<std::vector<Winding>> around(Vec3 point, std::uint32_t own) const {
        constexpr double kFar = 0x1p60;
        const Vec3 inSteps = point * 0.5;
        std::vector<Winding> crossed;
        bool isOnShell = false;
        m_tree.visitOverlapping({inSteps, {inSteps.x, inSteps.y, kFar}}, [&](std::uint32_t triangle) {
            if (m_shellOf[triangle] == own || m_surface.isDegenerate(triangle) || isOnShell) return;
            isOnShell = isOn(point, triangle);
            if (const int passage = passageAbove(point, triangle)) crossed.push_back({m_shellOf[triangle], passage});
        });
        if (isOnShell) return std::nullopt;
        std::ranges::sort(crossed, {}, &Winding::shell);
        std::vector<Winding> windings;
        for (const Winding& passage : crossed) {
            if (windings.empty() || windings.back().shell != passage.shell) windings.push_back({passage.shell, 0});
            windings.back().number += passage.number;
        }
        std::erase_if(windings, [](const Winding& winding) { return winding.number == 0; });
        return windings;
    }

private:
    Vec3 corner(std::uint32_t triangle, int k) const { return m_surface.corner(triangle, k) * 2.0; }

    bool isOn(Vec3 point, std::uint32_t triangle) const {
        const Vec3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
        if (volumeSign(a, b, c, point) != 0) return false;
        const auto [axis, sign] = m_surface.views[triangle];
        return sign * areaSign(a, b, point, axis) >= 0 && sign * areaSign(b, c, point, axis) >= 0 &&
               sign * areaSign(c, a, point, axis) >= 0;
    }

    /// +1 if the way upward from a point leaves the solid through a triangle, -1 if it enters it, else 0. The way is
    /// moved infinitely little to the right, and much less forward, so that it meets no edge.
    int passageAbove(Vec3 point, std::uint32_t triangle) const {
        const std::array<Vec3, 3> corners{corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)};
        const int sign = areaSign(corners[0], corners[1], corners[2], 2);
        if (sign == 0) return 0;
        for (int k = 0; k < 3; ++k) {
            const Vec3 from = corners[k], to = corners[(k + 1) % 3];
            int side = areaSign(from, to, point, 2);
            if (side == 0) side = from.y > to.y ? 1 : from.y < to.y ? -1 : to.x > from.x ? 1 : -1;
            if (side != sign) return 0;
        }
        const bool isBelow = volumeSign(corners[0], corners[1], corners[2], point) * sign < 0;
        return isBelow ? sign : 0;
    }

    const LatticeSurface& m_surface;
    const std::vector<std::uint32_t>& m_shellOf;
    const TriangleTree& m_tree;
};

class Nesting {
public:
    Nesting(const LatticeSurface& surface, const std::vector<Vec3>& points, const std::vector<std::uint32_t>& shellOf,
            const TriangleTree& tree)
        : m_surface(surface), m_points(points), m_shellOf(shellOf), m_around(surface, shellOf, tree) {}

    Result<ShellNesting> find(const TaskContext& task) {
        measure();
        m_windings.resize(m_result.shells.size());
        if (m_result.shells.size() > 1) {
            forEachIndex(m_result.shells.size(), task.threads, [&](std::size_t shell) {
                if (!task.isCancelled()) m_windings[shell] = windingsAround(static_cast<std::uint32_t>(shell));
            });
        }
        if (task.isCancelled()) return TaskContext::cancelled();
        turnOuterShells();
        nest();
        numberParts();
        return std::move(m_result);
    }

private:
    void measure() {
        const auto count = static_cast<std::uint32_t>(m_shellOf.size());
        std::vector<MeshShell>& shells = m_result.shells;
        for (std::uint32_t t = 0; t < count; ++t) {
            const std::uint32_t s = m_shellOf[t];
            if (s == shells.size()) shells.push_back({.firstTriangle = t});
            MeshShell& shell = shells[s];
            ++shell.triangleCount;
            const auto [a, b, c] = m_surface.triangles[t];
            const Vec3 origin = m_points[m_surface.triangles[shell.firstTriangle][0]];
            const Vec3 area = glm::cross(m_points[b] - m_points[a], m_points[c] - m_points[a]) / 2.0;
            shell.volume += glm::dot(m_points[a] - origin, area) / 3.0;
            shell.area += glm::length(area);
        }
        m_first.assign(shells.size() + 1, 0);
        for (std::size_t s = 0; s < shells.size(); ++s)
            m_first[s + 1] = m_first[s] + static_cast<std::uint32_t>(shells[s].triangleCount);
        m_trianglesByShell.resize(count);
        std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
        for (std::uint32_t t = 0; t < count; ++t) m_trianglesByShell[next[m_shellOf[t]]++] = t;
    }

    std::span<const std::uint32_t> trianglesOf(std::uint32_t shell) const {
        return std::span(m_trianglesByShell).subspan(m_first[shell], m_first[shell + 1] - m_first[shell]);
    }

    /// The windings of the others around a shell: at a corner or middle of an edge that touches none of them. Where all
    /// of them touch, a little behind a triangle.
    std::vector<Winding> windingsAround(std::uint32_t shell) const {
        for (const std::uint32_t t : trianglesOf(shell)) {
            for (int k = 0; k < 3; ++k) {
                const Vec3 from = m_surface.corner(t, k), to = m_surface.corner(t, (k + 1) % 3);
                for (const Vec3 point : {from * 2.0, from + to}) {
                    if (const auto windings = m_around.around(point, shell)) return *windings;
                }
            }
        }
        for (const std::uint32_t t : trianglesOf(shell)) {
            if (m_surface.isDegenerate(t)) continue;
            constexpr double kDepth = 32.0;  // half steps
            const Vec3 a = m_surface.corner(t, 0), b = m_surface.corner(t, 1), c = m_surface.corner(t, 2);
            const Vec3 inward = glm::normalize(glm::cross(c - a, b - a));
            const Vec3 behind = glm::round((a + b + c) * (2.0 / 3.0) + inward * kDepth);
            if (const auto windings = m_around.around(glm::max(behind, Vec3(0.0)), shell)) return *windings;
        }
        return {};
    }

    /// Turns outer shells of negative volume, and all that is in them.
    void turnOuterShells() {
        m_result.turned.assign(m_result.shells.size(), 0);
        const auto isOuterAndInverted = [&](std::uint32_t shell) {
            return m_windings[shell].empty() && m_result.shells[shell].volume < 0.0;
        };
        for (std::uint32_t s = 0; s < m_result.shells.size(); ++s) {
            m_result.turned[s] =
                isOuterAndInverted(s) || std::ranges::any_of(m_windings[s], [&](const Winding& winding) {
                    return isOuterAndInverted(winding.shell);
                });
        }
        for (std::uint32_t s = 0; s < m_result.shells.size(); ++s) {
            if (m_result.turned[s]) m_result.shells[s].volume = -m_result.shells[s].volume;
        }
    }

    void nest() {
        for (std::uint32_t s = 0; s < m_result.shells.size(); ++s) {
            MeshShell& shell = m_result.shells[s];
            std::size_t deepest = 0;
            int number = 0;  // of the space around it
            for (const Winding& winding : m_windings[s]) {
                number += m_result.turned[winding.shell] ? -winding.number : winding.number;
                if (shell.around != kNone && m_windings[winding.shell].size() <= deepest) continue;
                shell.around = winding.shell;
                deepest = m_windings[winding.shell].size();
            }
            if (shell.around != kNone && number != (shell.isCavity() ? 1 : 0))
                m_result.overlapping.push_back({s, shell.around});
        }
    }

    void numberParts() {
        std::vector<MeshShell>& shells = m_result.shells;
        for (MeshShell& shell : shells) {
            if (!shell.isCavity() || shell.around == kNone) shell.part = m_result.partCount++;
        }
        for (MeshShell& shell : shells) {
            if (shell.isCavity() && shell.around != kNone) shell.part = shells[shell.around].part;
        }
    }

    const LatticeSurface& m_surface;
    const std::vector<Vec3>& m_points;
    const std::vector<std::uint32_t>& m_shellOf;
    ShellsAround m_around;
    std::vector<std::uint32_t> m_first, m_trianglesByShell;
    std::vector<std::vector<Winding>> m_windings;  // of the others around each shell
    ShellNesting m_result;
};

}  // namespace

Result<ShellNesting> nestShells(const LatticeSurface& surface, const std::vector<Vec3>& points,
                                const std::vector<std::uint32_t>& shellOf, const TriangleTree& tree,
                                const TaskContext& task) {
    return Nesting(surface, points, shellOf, tree).find(task);
}

}  // namespace rubble
