#pragma once

#include "core/base/Index.h"
#include "core/base/Result.h"
#include "core/geometry/hull/HullTriangles.h"

#include <span>
#include <vector>

namespace rubble {

/// Four points that are not coplanar, the last below the plane of the others.
using HullSimplex = std::array<std::uint32_t, 4>;

/// The simplex that a hull of points grows from: far from each other, the first point among them.
///
/// Errors: those of hullTriangles().
Result<HullSimplex> firstSimplex(std::span<const Vec3> points);

/// A convex hull of triangles that grows by one point at a time, by exact predicates.
class GrowingHull {
public:
    /// `points` has to outlive the hull.
    GrowingHull(std::span<const Vec3> points, const HullSimplex& simplex);

    /// The number of faces so far, those that were replaced included.
    std::uint32_t faceCount() const { return static_cast<std::uint32_t>(m_faces.size()); }
    bool isAlive(std::uint32_t face) const { return m_faces[face].isAlive; }
    const HullTriangle& triangle(std::uint32_t face) const { return m_faces[face].triangle; }
    /// Whether a point is outside a face; a point in its plane is not.
    bool sees(std::uint32_t point, std::uint32_t face) const;

    /// Replaces the faces that a point sees, of which `start` is one, by the cone from it over their horizon. These are
    /// the last faces. Returns the first of them.
    std::uint32_t add(std::uint32_t point, std::uint32_t start);
    /// The faces that the last point replaced.
    std::span<const std::uint32_t> replaced() const { return m_visible; }

    /// The triangles of the hull.
    std::vector<HullTriangle> triangles() const;

private:
    struct Face {
        HullTriangle triangle;
        bool isAlive = true;
        std::uint32_t seenBy = kNone;  // the last point found to see it
    };
    struct HorizonEdge {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t beyond;  // the face that remains
    };

    void findVisible(std::uint32_t point, std::uint32_t start);
    void findHorizon(std::uint32_t point);
    void linkBeyond(const HorizonEdge& edge, std::uint32_t face);

    std::span<const Vec3> m_points;
    std::vector<Face> m_faces;
    std::vector<std::uint32_t> m_visible;
    std::vector<HorizonEdge> m_horizon;
    std::vector<std::uint32_t> m_faceFrom;  // per point: the new face whose horizon edge starts there
};

}  // namespace rubble
