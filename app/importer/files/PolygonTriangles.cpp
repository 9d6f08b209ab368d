#include "app/importer/files/PolygonTriangles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace rubble {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// Twice the area times the unit normal, by Newell's method.
Vec3 newellNormal(std::span<const Vec3> corners) {
    Vec3 normal(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return normal;
}

/// The corners seen against the normal, along the axis that it is closest to; counter-clockwise as a whole.
std::vector<Vec2> projected(std::span<const Vec3> corners, Vec3 normal) {
    const Vec3 size = glm::abs(normal);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    if (normal[axis] < 0.0) std::swap(u, v);
    std::vector<Vec2> points;
    points.reserve(corners.size());
    for (const Vec3 corner : corners) points.emplace_back(corner[u] - corners[0][u], corner[v] - corners[0][v]);
    return points;
}

double cross(Vec2 a, Vec2 b, Vec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

Triangles fan(std::span<const std::uint32_t> ring) {
    Triangles triangles;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) triangles.push_back({ring[0], ring[i], ring[i + 1]});
    return triangles;
}

/// Cuts off ears: corners whose triangle holds no other corner.
class EarClipper {
public:
    explicit EarClipper(std::vector<Vec2> points) : m_points(std::move(points)), m_ring(m_points.size()) {
        std::iota(m_ring.begin(), m_ring.end(), 0u);
    }

    bool isConvex() const {
        for (std::size_t i = 0; i < m_ring.size(); ++i)
            if (cornerArea(i) < 0.0) return false;
        return true;
    }
    Triangles triangles() {
        Triangles all;
        std::size_t at = 0, tried = 0;
        while (m_ring.size() > 3 && tried < m_ring.size()) {
            if (at >= m_ring.size()) at = 0;
            if (!isEar(at)) {
                ++at;
                ++tried;
                continue;
            }
            all.push_back({m_ring[before(at)], m_ring[at], m_ring[after(at)]});
            m_ring.erase(m_ring.begin() + static_cast<std::ptrdiff_t>(at));
            tried = 0;
        }
        const Triangles rest = fan(m_ring);
        all.insert(all.end(), rest.begin(), rest.end());
        return all;
    }

private:
    std::size_t before(std::size_t i) const { return (i == 0 ? m_ring.size() : i) - 1; }
    std::size_t after(std::size_t i) const { return i + 1 == m_ring.size() ? 0 : i + 1; }
    Vec2 point(std::size_t i) const { return m_points[m_ring[i]]; }
    double cornerArea(std::size_t i) const { return cross(point(before(i)), point(i), point(after(i))); }

    bool isEar(std::size_t i) const {
        if (!(cornerArea(i) > 0.0)) return false;
        const Vec2 a = point(before(i)), b = point(i), c = point(after(i));
        for (std::size_t k = 0; k < m_ring.size(); ++k) {
            const Vec2 p = point(k);
            if (k == i || k == before(i) || k == after(i) || p == a || p == b || p == c) continue;
            if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    std::vector<Vec2> m_points;
    std::vector<std::uint32_t> m_ring;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> polygonTriangles(std::span<const Vec3> corners) {
    std::vector<std::uint32_t> ring(corners.size());
    std::iota(ring.begin(), ring.end(), 0u);
    if (corners.size() == 3) return fan(ring);
    EarClipper clipper(projected(corners, newellNormal(corners)));
    return clipper.isConvex() ? fan(ring) : clipper.triangles();
}

}  // namespace rubble
