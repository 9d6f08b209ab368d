#pragma once

#include "core/fracture/delaunay/Delaunay.h"
#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/predicates/Vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubble {

/// A directed line through two different points.
struct DirectedLine {
    Vec2 from;
    Vec2 to;
};

/// Exact predicates on the Voronoi diagram of a triangulation; no sign is ever zero.
///
/// Ties are broken by one symbolic perturbation, the same as in triangulate(): every lifted site is lowered by an
/// infinitesimal amount, the lowest seed index by far the most, so that its cell grows. All signs are those of the
/// perturbed diagram and hence consistent: a corner is on one side of every line, and a line enters a cell as often as
/// it leaves it.
///
/// Glossary. Corner: the Voronoi vertex of a triangle, its circumcentre; of a ghost triangle, the point at infinity on
/// its outer side.
/// Source: the perturbation is that of Edelsbrunner, Mücke 1990, on the lifting map.
class PerturbedDiagram {
public:
    explicit PerturbedDiagram(const Delaunay& delaunay) : m_delaunay(delaunay) {}

    /// +1 if the triangle's corner lies left of the line, -1 if right of it.
    int sideOfCorner(const DirectedLine& line, std::uint32_t triangle) const;

    /// Whether the point is nearer to site i than to site j.
    bool isNearer(Vec2 point, std::uint32_t i, std::uint32_t j) const;

    /// Whether `first` crosses the bisector of i and j before `second` does, counter-clockwise around i.
    bool crossesBefore(std::uint32_t i, std::uint32_t j, const DirectedLine& first, const DirectedLine& second) const;

private:
    int sideOfInfinity(const DirectedLine& line, std::uint32_t a, std::uint32_t b) const;
    int sideOfTiedCorner(const DirectedLine& line, const Delaunay::Triangle& triangle) const;

    const Delaunay& m_delaunay;
};

/// The maximum error of computed corners and crossings, relative to the bounding radius.
inline constexpr double kConstructionError = 0x1p-48;

/// The circumcentre of a counter-clockwise triangle, relative to `origin`, rounded. The error is at most
/// kConstructionError times the larger of `boundingRadius` and the centre's distance. Falls back to exact arithmetic
/// for thin triangles, unless the centre is certainly farther than `boundingRadius` in x or y; then it is less
/// accurate.
inline Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c, Vec2 origin, double boundingRadius);
/// The same, by exact arithmetic.
Vec2 circumcentreExactly(Vec2 a, Vec2 b, Vec2 c, Vec2 origin);

/// The intersection of a line, from its first point to its second, with the bisector of a and b, relative to `origin`,
/// to the same precision; the nearer of both points if the bisector passes beyond it.
Vec2 intersectionWithBisector(const DirectedLine& line, Vec2 a, Vec2 b, Vec2 origin, double boundingRadius);

inline Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c, Vec2 origin, double boundingRadius) {
    const Vec2 ab = b - a, ac = c - a;
    const double bSquare = ab.x * ab.x + ab.y * ab.y, cSquare = ac.x * ac.x + ac.y * ac.y;
    const double doubledArea = cross(ab, ac), inverse = 0.5 / doubledArea;
    const Vec2 offset = {(bSquare * ac.y - cSquare * ab.y) * inverse, (cSquare * ab.x - bSquare * ac.x) * inverse};
    // Forward error: six roundings per numerator, five in the denominator.
    const double longest = std::max(std::max(std::abs(ab.x), std::abs(ab.y)), std::max(std::abs(ac.x), std::abs(ac.y)));
    const double far = std::max(std::abs(offset.x), std::abs(offset.y));
    const double error = 8.0 * kRounding * longest * inverse * (bSquare + cSquare + 4.0 * longest * far);
    const Vec2 centre = (a - origin) + offset;
    if (doubledArea > 0.0) {
        if (error <= kConstructionError * std::max(boundingRadius, far)) return centre;
        // Certainly farther than the bounding radius: it is no corner of a piece. While error < far the bound holds to
        // first order.
        if (error < far && std::max(std::abs(centre.x), std::abs(centre.y)) - error > boundingRadius) return centre;
    }
    return circumcentreExactly(a, b, c, origin);
}

}  // namespace rubble
