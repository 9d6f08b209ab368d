#include "core/geometry/hull/SimplifiedHull.h"

#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/GrowingHull.h"
#include "core/geometry/hull/InsetHull.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "core/geometry/search/Box3.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// Adds the points of a hull that are outside by more than a tolerance, those first that add the most volume.
class GreedyHull {
public:
    GreedyHull(std::span<const Vec3> points, const HullSimplex& simplex)
        : m_points(points), m_hull(points, simplex), m_added(simplex.begin(), simplex.end()) {
        for (std::uint32_t point = 0; point < points.size(); ++point) {
            Outside outside{.point = point};
            measure(outside, 0);
            if (outside.nearest != kNone) m_outside.push_back(outside);
        }
    }

    void addUntil(const HullDetail& detail) {
        const auto volumeOf = [&](const Outside& o) {
            return o.distance > detail.tolerance ? std::max(o.volume, 0.0) : -1.0;
        };
        while (!m_outside.empty() && m_added.size() < detail.maxCorners) {
            const auto largest = std::ranges::max_element(m_outside, {}, volumeOf);
            if (largest->distance <= detail.tolerance) break;
            add(largest->point, largest->nearest);
        }
    }

    /// The points added, ascending.
    std::vector<std::uint32_t> added() && {
        std::ranges::sort(m_added);
        return std::move(m_added);
    }

private:
    struct Outside {
        std::uint32_t point;
        std::uint32_t nearest = kNone;  // the nearest face, which the point sees
        double distance = 0.0;          // m, to it
        double volume = 0.0;            // m³, six times that between the point and the faces that it sees
    };

    double volumeOver(std::uint32_t face, std::uint32_t point) const {
        const auto& [a, b, c] = m_hull.triangle(face).corners;
        const Vec3 origin = m_points[a];
        return glm::dot(glm::cross(m_points[b] - origin, m_points[c] - origin), m_points[point] - origin);
    }

    /// Measures the distance and the volume to the faces from `first` on. The point of the hull that is nearest to a
    /// point outside is on a face that this sees.
    void measure(Outside& outside, std::uint32_t first) const {
        for (std::uint32_t face = first; face < m_hull.faceCount(); ++face) {
            if (!m_hull.isAlive(face) || !m_hull.sees(outside.point, face)) continue;
            outside.volume += std::max(volumeOver(face, outside.point), 0.0);
            const auto& [a, b, c] = m_hull.triangle(face).corners;
            const double distance = distanceToTriangle(m_points[outside.point], m_points[a], m_points[b], m_points[c]);
            if (outside.nearest != kNone && distance >= outside.distance) continue;
            outside.nearest = face;
            outside.distance = distance;
        }
    }

    void add(std::uint32_t point, std::uint32_t face) {
        const std::uint32_t firstNew = m_hull.add(point, face);
        m_added.push_back(point);
        std::erase_if(m_outside, [&](Outside& outside) {
            if (outside.point == point) return true;
            if (m_hull.isAlive(outside.nearest)) {
                for (const std::uint32_t old : m_hull.replaced()) {
                    if (m_hull.sees(outside.point, old))
                        outside.volume -= std::max(volumeOver(old, outside.point), 0.0);
                }
                measure(outside, firstNew);
                return false;
            }
            outside = {.point = outside.point};
            measure(outside, 0);
            return outside.nearest == kNone;
        });
    }

    std::span<const Vec3> m_points;
    GrowingHull m_hull;
    std::vector<std::uint32_t> m_added;
    std::vector<Outside> m_outside;
};

}  // namespace

HullDetail collisionDetail(const Polytope& hull) {
    Box3 box;
    for (const Vec3& corner : hull.vertices) box.include(corner);
    const double most = std::min(kMaxHullError, kMaxHullErrorOfDiagonal * box.diagonal());
    return {std::min(most, kMaxHullErrorOfWidth * thinnestWidth(hull)), kMaxCollisionCorners};
}

double maxCollisionError(std::size_t corners, double diagonal) {
    if (corners >= kMaxCollisionCorners) return kMaxErrorAtMostCorners * diagonal;
    return std::min(kMaxHullError, kMaxHullErrorOfDiagonal * diagonal);
}

Polytope simplifiedHull(const Polytope& hull, const HullDetail& detail) {
    const Result<HullSimplex> simplex = firstSimplex(hull.vertices);
    if (!simplex) return hull;
    GreedyHull greedy(hull.vertices, *simplex);
    greedy.addUntil(detail);
    const std::vector<std::uint32_t> added = std::move(greedy).added();
    if (added.size() == hull.vertices.size()) return hull;
    std::vector<Vec3> corners;
    for (const std::uint32_t corner : added) corners.push_back(hull.vertices[corner]);
    Result<Polytope> simplified = convexHull(corners, flatnessOf(corners));
    return simplified ? std::move(*simplified) : hull;
}

}  // namespace rubble
