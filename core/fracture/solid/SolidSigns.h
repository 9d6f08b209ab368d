#pragma once

#include "core/geometry/predicates/BoundedDouble.h"
#include "core/geometry/predicates/Vec.h"
#include "core/geometry/predicates/WideInteger.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

namespace rubble {

/// A site with its rank: the lower it is, the more the lifted site is lowered.
struct RankedSite {
    Vec3 point{0.0, 0.0, 0.0};  // on the lattice
    std::uint32_t rank = 0;     // of no other site
};

/// The signs on which the cut of a solid depends, all on the lattice of a SolidLattice, or four times as far out for
/// inSphere(). None is ever zero: sites i have infinitesimal weights w_i, the lowest rank's largest, and ties are
/// decided as these say, for all functions alike: docs/adr/0063.
///
/// `h_ij(x) = |x - s_i|² - w_i - |x - s_j|² + w_j` is negative in the cell of i and positive in that of j.
namespace solid_signs {

/// h_ij at a point without its weights, by a filter and exactly.
inline BoundedDouble bisectorValue(Vec3 x, Vec3 i, Vec3 j) {
    const Vec3 product = (j - i) * (2.0 * x - i - j);  // of exact differences
    const double magnitude = std::abs(product.x) + std::abs(product.y) + std::abs(product.z);
    return {product.x + product.y + product.z, 4.0 * kRounding * magnitude};
}
Int128 exactBisectorValue(Vec3 x, Vec3 i, Vec3 j);

/// For corners with orient3d(a, b, c, d) > 0: +1 if p lies inside their sphere, -1 outside.
int inSphere(const RankedSite& a, const RankedSite& b, const RankedSite& c, const RankedSite& d, const RankedSite& p);

/// The sign of h_il at a point: +1 beyond the bisector, -1 on the side of i.
int atPoint(Vec3 x, const RankedSite& i, const RankedSite& l);

/// The sign of h_ij(a) h_il(b) - h_ij(b) h_il(a). Where a segment from a to b leaves the cell of i through the bisector
/// with j, so that h_ij(a) < h_ij(b), that is opposite to the sign of h_il there.
int edgeDeterminant(Vec3 a, Vec3 b, const RankedSite& i, const RankedSite& j, const RankedSite& l);

/// The sign of det(H_ij, H_ik, H_il), with H the values at three corners. Where the bisectors with j and k meet in the
/// triangle of the corners, and (1, 1, 1) · (H_ij × H_ik) > 0, that is the sign of h_il there.
int triangleDeterminant(const std::array<Vec3, 3>& corners, const RankedSite& i, const RankedSite& j,
                        const RankedSite& k, const RankedSite& l);

/// The order of the points at which two triangles meet the Voronoi edge of i, j and k, along d = (s_j - s_i) × (s_k -
/// s_i): -1 if that of `a` comes first, +1 if that of `b` does; 0 if they coincide, which only coplanar triangles can.
/// `leavesA`: whether the triangle's normal points along d.
int orderAlongEdge(const std::array<Vec3, 3>& a, bool leavesA, const std::array<Vec3, 3>& b, bool leavesB,
                   const RankedSite& i, const RankedSite& j, const RankedSite& k);

}  // namespace solid_signs
}  // namespace rubble
