#include "core/fracture/solid/FaceTriangulation.h"

#include "core/geometry/polygon/ConvexParts.h"
#include "core/geometry/predicates/Predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace rubble {
namespace {

constexpr std::size_t kMaxClippedCorners = 24;  // more are triangulated by a sweep

/// Clips ears off a ring of corners, the best shaped first.
class EarClipper {
public:
    EarClipper(std::span<const Vec2> points, double tolerance, PointTriangles& triangles)
        : m_points(points),
          m_tolerance(tolerance),
          m_next(points.size()),
          m_previous(points.size()),
          m_quality(points.size()),
          m_triangles(triangles) {}

    /// Writes triangles as the point indices in `names`.
    void clip(std::span<const std::uint32_t> names) {
        const std::uint32_t count = static_cast<std::uint32_t>(m_points.size());
        for (std::uint32_t k = 0; k < count; ++k) {
            m_next[k] = k + 1 < count ? k + 1 : 0;
            m_previous[k] = k > 0 ? k - 1 : count - 1;
        }
        for (std::uint32_t k = 0; k < count; ++k) m_quality[k] = qualityOf(k);
        std::uint32_t any = 0;
        for (std::uint32_t left = count; left > 3; --left) {
            std::uint32_t best = any;
            for (std::uint32_t k = m_next[any]; k != any; k = m_next[k]) {
                if (m_quality[k] > m_quality[best]) best = k;
            }
            const std::uint32_t before = m_previous[best], after = m_next[best];
            add(names[before], names[best], names[after]);
            m_next[before] = after, m_previous[after] = before;
            m_quality[before] = qualityOf(before);
            m_quality[after] = qualityOf(after);
            any = after;
        }
        add(names[m_previous[any]], names[any], names[m_next[any]]);
    }

private:
    /// Adds a triangle, unless it goes there and back, as along the way to a hole.
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        if (a != b && b != c && c != a) m_triangles.push_back({a, b, c});
    }

    /// Twice the area over the square of the longest side; for corners that are no ears, lower the worse they are.
    double qualityOf(std::uint32_t corner) const {
        const std::uint32_t before = m_previous[corner], after = m_next[corner];
        const Vec2 a = m_points[before], b = m_points[corner], c = m_points[after];
        const double longest = std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
        // The tip of a slit, where the ring goes there and back, and an edge without length: to be clipped first.
        if (coincide(a, b) || coincide(b, c) || coincide(c, a)) return 4.0;
        const double shape = cross(b - a, c - a) / longest;
        if (orient2d(a, b, c) <= 0) return shape - 2.0;
        for (std::uint32_t k = m_next[after]; k != before; k = m_next[k]) {
            const Vec2 p = m_points[k];
            if (p == a || p == b || p == c) continue;
            if (orient2d(a, b, p) >= 0 && orient2d(b, c, p) >= 0 && orient2d(c, a, p) >= 0) return shape - 4.0;
        }
        return shape;
    }

    bool coincide(Vec2 a, Vec2 b) const {
        return std::abs(a.x - b.x) <= m_tolerance && std::abs(a.y - b.y) <= m_tolerance;
    }

    std::span<const Vec2> m_points;
    double m_tolerance;
    std::vector<std::uint32_t> m_next, m_previous;
    std::vector<double> m_quality;
    PointTriangles& m_triangles;
};

bool isStrictlyConvex(std::span<const Vec3> points, std::span<const std::uint32_t> loop, const PlaneView& view) {
    const std::size_t count = loop.size();
    Vec2 a = view(points[loop[count - 2]]), b = view(points[loop[count - 1]]);
    int turns = 0;  // of the direction from left to right: two in a ring that goes around once
    for (const std::uint32_t point : loop) {
        const Vec2 c = view(points[point]);
        if (orient2d(a, b, c) <= 0) return false;
        turns += lexicographicLess(a, b) != lexicographicLess(b, c);
        a = b, b = c;
    }
    return turns == 2;
}

/// One ring through the outer loop and the holes, joined by pairs of edges between their nearest corners.
PointLoop joinedLoops(std::span<const Vec3> points, std::span<const PointLoop> loops, const PlaneView& view) {
    PointLoop ring = loops[0];
    std::vector<bool> isJoined(loops.size());
    for (std::size_t joined = 1; joined < loops.size(); ++joined) {
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t loop = 0, at = 0, from = 0;
        for (std::size_t l = 1; l < loops.size(); ++l) {
            if (isJoined[l]) continue;
            for (std::size_t k = 0; k < loops[l].size(); ++k) {
                for (std::size_t r = 0; r < ring.size(); ++r) {
                    const double distance = squaredLength(view(points[loops[l][k]]) - view(points[ring[r]]));
                    if (distance < nearest) nearest = distance, loop = l, at = r, from = k;
                }
            }
        }
        isJoined[loop] = true;
        PointLoop hole = loops[loop];
        std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(from), hole.end());
        hole.push_back(hole.front());
        if (hole.front() == ring[at])
            hole.erase(hole.begin());  // they touch there
        else
            hole.push_back(ring[at]);
        ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(at) + 1, hole.begin(), hole.end());
    }
    return ring;
}

std::vector<Vec2> seen(std::span<const Vec3> points, std::span<const std::uint32_t> loop, const PlaneView& view) {
    std::vector<Vec2> ring(loop.size());
    for (std::size_t k = 0; k < loop.size(); ++k) ring[k] = view(points[loop[k]]);
    return ring;
}

/// Triangulates loops of a valid polygon; nothing where rounding has made it invalid. Where loops touch in different
/// points at one place, a triangle without area leads from one to the other.
std::optional<std::vector<std::array<std::uint32_t, 3>>> sweptTriangles(std::span<const Vec3> points,
                                                                        std::span<const PointLoop> loops,
                                                                        const PlaneView& view) {
    Polygon polygon{seen(points, loops[0], view), {}};
    std::vector<std::uint32_t> names, next;  // of each corner; as the loop goes
    for (const PointLoop& loop : loops) {
        const std::uint32_t first = static_cast<std::uint32_t>(names.size());
        names.insert(names.end(), loop.begin(), loop.end());
        for (std::uint32_t k = 1; k < loop.size(); ++k) next.push_back(first + k);
        next.push_back(first);
    }
    for (const PointLoop& hole : loops.subspan(1)) polygon.holes.push_back(seen(points, hole, view));
    const Result<IndexLoops> swept = rubble::triangles(polygon);
    if (!swept) return std::nullopt;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const std::vector<std::uint32_t>& triangle : *swept) {
        triangles.push_back({names[triangle[0]], names[triangle[1]], names[triangle[2]]});
        for (int k = 0; k < 3; ++k) edges.emplace_back(triangle[k], triangle[(k + 1) % 3]);
    }
    std::ranges::sort(edges);
    for (const auto& [from, to] : edges) {
        if (names[to] == names[next[from]] || std::ranges::binary_search(edges, std::pair(to, from))) continue;
        triangles.push_back({names[from], names[next[from]], names[to]});  // an edge of a loop, to another point there
    }
    return triangles;
}

}  // namespace

PlaneView::PlaneView(Vec3 normal) {
    const Vec3 size = {std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)};
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    right = (dropped + 1) % 3, up = (dropped + 2) % 3;
    if (normal[dropped] < 0.0) std::swap(right, up);
}

bool triangulateConvex(std::span<const Vec3> points, const PointLoop& loop, const PlaneView& view,
                       PointTriangles& triangles) {
    if (loop.size() > 3 && !isStrictlyConvex(points, loop, view)) return false;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) triangles.push_back({loop[0], loop[k], loop[k + 1]});
    return true;
}

void triangulateFace(std::span<const Vec3> points, std::span<const PointLoop> loops, const PlaneView& view,
                     double tolerance, PointTriangles& triangles) {
    const PointLoop& outer = loops[0];
    if (loops.size() > 1 || outer.size() > kMaxClippedCorners) {
        if (const auto swept = sweptTriangles(points, loops, view)) {
            triangles.insert(triangles.end(), swept->begin(), swept->end());
            return;
        }
    }
    const PointLoop whole = loops.size() > 1 ? joinedLoops(points, loops, view) : outer;
    const std::vector<Vec2> corners = seen(points, whole, view);
    EarClipper(corners, tolerance, triangles).clip(whole);
}

}  // namespace rubble
