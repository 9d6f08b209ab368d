#pragma once

#include "core/fracture/Delaunay.h"
#include "core/geometry/Predicates.h"
#include "core/geometry/Vec.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rubble {

/// A directed line through two different points.
struct DirectedLine {
    Vec2 from;
    Vec2 to;
};

/// The Voronoi diagram of a triangulation as exact signs, never zero.
///
/// Ties are broken by one perturbation, the same as in triangulate(): every lifted site is pulled down by an
/// infinitesimal amount, the lowest seed index by far the most, so that its cell grows. All signs are those of that
/// perturbed diagram, so they never contradict each other: a corner is on one side of every line, a line enters a cell
/// exactly as often as it leaves it.
///
/// Glossary. Corner: the Voronoi corner of a triangle, its circumcentre; of a ghost triangle, the point at infinity
/// in the direction of its outside.
/// Source: the perturbation is that of Edelsbrunner, Mücke 1990, on the lifting map.
class PerturbedDiagram {
public:
    explicit PerturbedDiagram(const Delaunay& delaunay) : m_delaunay(delaunay) {}

    /// +1 where the triangle's corner lies left of the line, -1 where it lies right of it.
    int sideOfCorner(const DirectedLine& line, std::uint32_t triangle) const;

    /// True where the point belongs to the cell of site i rather than to that of j.
    bool isNearer(Vec2 point, std::uint32_t i, std::uint32_t j) const;

    /// Two lines cross the bisector of i and j: whether `first` does so before `second`, going counter-clockwise around i.
    bool crossesBefore(std::uint32_t i, std::uint32_t j, const DirectedLine& first, const DirectedLine& second) const;

private:
    int sideOfInfinity(const DirectedLine& line, std::uint32_t a, std::uint32_t b) const;
    int sideOfTiedCorner(const DirectedLine& line, const Delaunay::Triangle& triangle) const;

    const Delaunay& m_delaunay;
};

/// How exactly corners and crossings are computed: their error is at most this times the reach.
inline constexpr double kConstructionError = 0x1p-48;

/// Circumcentre of a counter-clockwise triangle, relative to `origin`, rounded: off by at most kConstructionError times
/// the larger of `reach` and its own distance. Falls back to exact numbers where the triangle is thin, unless the centre
/// lies beyond `reach` in x or y anyway; then it is less exact, but beyond it.
inline Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c, Vec2 origin, double reach);
/// The same, from exact numbers.
Vec2 circumcentreExactly(Vec2 a, Vec2 b, Vec2 c, Vec2 origin);

/// Where a line crosses the bisector of a and b, relative to `origin`, to the same precision.
Vec2 crossingWithBisector(const DirectedLine& line, Vec2 a, Vec2 b, Vec2 origin, double reach);

inline Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c, Vec2 origin, double reach) {
    const Vec2 ab = b - a, ac = c - a;
    const double bSquare = ab.x * ab.x + ab.y * ab.y, cSquare = ac.x * ac.x + ac.y * ac.y;
    const double doubledArea = cross(ab, ac), inverse = 0.5 / doubledArea;
    const Vec2 offset = {(bSquare * ac.y - cSquare * ab.y) * inverse, (cSquare * ab.x - bSquare * ac.x) * inverse};
    // Forward error: six roundings a numerator, five in the denominator.
    const double longest = std::max(std::max(std::abs(ab.x), std::abs(ab.y)), std::max(std::abs(ac.x), std::abs(ac.y)));
    const double far = std::max(std::abs(offset.x), std::abs(offset.y));
    const double error = 8.0 * kRounding * longest * inverse * (bSquare + cSquare + 4.0 * longest * far);
    const Vec2 centre = (a - origin) + offset;
    if (doubledArea > 0.0) {
        if (error <= kConstructionError * std::max(reach, far)) return centre;
        // Beyond the reach for certain: no piece has it as a corner. While error < far the bound holds to first order.
        if (error < far && std::max(std::abs(centre.x), std::abs(centre.y)) - error > reach) return centre;
    }
    return circumcentreExactly(a, b, c, origin);
}

}  // namespace rubble
