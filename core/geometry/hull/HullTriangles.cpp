#include "core/geometry/hull/HullTriangles.h"

#include "core/geometry/hull/GrowingHull.h"

#include <utility>

namespace rubble {

namespace {

/// A hull that all points are added to. Every point outside is in the outside set of one face that it sees.
class Quickhull {
public:
    Quickhull(std::span<const Vec3> points, const HullSimplex& simplex)
        : m_points(points), m_hull(points, simplex), m_outside(m_hull.faceCount()) {
        for (std::uint32_t point = 0; point < points.size(); ++point) assign(point, 0);
    }

    void addAllPoints() {
        for (std::uint32_t face = 0; face < m_hull.faceCount(); ++face) {
            if (m_hull.isAlive(face) && !m_outside[face].empty()) addPoint(farthestOutside(face), face);
        }
    }

    std::vector<HullTriangle> triangles() const { return m_hull.triangles(); }

private:
    /// Adds the point to the outside set of the first face from `firstFace` on that it sees; a point that sees none is
    /// inside.
    void assign(std::uint32_t point, std::uint32_t firstFace) {
        for (std::uint32_t face = firstFace; face < m_hull.faceCount(); ++face) {
            if (m_hull.sees(point, face)) return m_outside[face].push_back(point);
        }
    }

    std::uint32_t farthestOutside(std::uint32_t face) const {
        const auto [a, b, c] = m_hull.triangle(face).corners;
        const Vec3 origin = m_points[a];
        const Vec3 normal = glm::cross(m_points[b] - origin, m_points[c] - origin);
        std::uint32_t best = m_outside[face][0];
        double most = glm::dot(normal, m_points[best] - origin);
        for (const std::uint32_t point : m_outside[face]) {
            const double height = glm::dot(normal, m_points[point] - origin);
            if (height < most || (height == most && point >= best)) continue;
            best = point;
            most = height;
        }
        return best;
    }

    void addPoint(std::uint32_t point, std::uint32_t start) {
        const std::uint32_t firstNew = m_hull.add(point, start);
        m_outside.resize(m_hull.faceCount());
        for (const std::uint32_t face : m_hull.replaced()) {
            const std::vector<std::uint32_t> unassigned = std::move(m_outside[face]);
            for (const std::uint32_t other : unassigned) {
                if (other != point) assign(other, firstNew);
            }
        }
    }

    std::span<const Vec3> m_points;
    GrowingHull m_hull;
    std::vector<std::vector<std::uint32_t>> m_outside;  // of each face
};

}  // namespace

Result<std::vector<HullTriangle>> hullTriangles(std::span<const Vec3> points) {
    const Result<HullSimplex> simplex = firstSimplex(points);
    if (!simplex) return simplex.error();
    Quickhull hull(points, *simplex);
    hull.addAllPoints();
    return hull.triangles();
}

}  // namespace rubble
