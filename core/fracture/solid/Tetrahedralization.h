#pragma once

#include "core/base/Index.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/geometry/mesh/SolidLattice.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The Delaunay triangulation of sites in space, inside four far sites: every cell of a site is bounded, and sets of
/// few, collinear or coplanar sites are no special cases. The far sites are so distant that their cells do not reach
/// the lattice's box: in it, the Voronoi diagram is that of the other sites, exactly.
///
/// Cospherical sites are ordered as ADR 0002 says: the lifted site of the lowest seed is lowered most, so the result
/// does not depend on the order of insertion.
struct Tetrahedralization {
    struct Tetrahedron {
        std::array<std::uint32_t, 4> corner;     // sites: orient3d() of them is positive
        std::array<std::uint32_t, 4> neighbour;  // the tetrahedron behind the face opposite each corner; kNone: none
    };

    std::vector<Vec3> sites;            // on the lattice, distinct, along a Hilbert curve; the last four are far
    std::vector<std::uint32_t> seedOf;  // input index of each site; of far ones, numbers above all of them
    std::vector<Tetrahedron> tetrahedra;
    std::vector<std::array<std::uint32_t, 2>> duplicates;  // {input index, that of the seed it equals}, ascending

    std::uint32_t siteCount() const { return static_cast<std::uint32_t>(sites.size()) - 4; }
    bool isFar(std::uint32_t site) const { return site >= siteCount(); }
};

/// The corners of the face opposite a corner, so ordered that the corner is on the positive side of orient3d().
inline constexpr std::array<std::array<std::uint8_t, 3>, 4> kFaceCorners = {
    {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

/// Triangulates seeds on the lattice, in O(n log n) expected time for evenly spread ones; of equal seeds, the one with
/// the lowest index is kept.
///
/// Errors: Cancelled.
/// Source: Bowyer, Computing Dirichlet tessellations, 1981; Watson, Computing the n-dimensional Delaunay tessellation,
/// 1981; Devillers, Teillaud, Perturbations for Delaunay and weighted Delaunay 3D triangulations, 2011.
Result<Tetrahedralization> tetrahedralized(std::span<const Vec3> seeds, const TaskContext& task = {});

}  // namespace rubble
