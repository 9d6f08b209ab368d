#pragma once

#include "core/base/RawVector.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Report.h"
#include "core/geometry/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The Delaunay triangulation of sites, closed by one ghost vertex at infinity: every edge of the hull has a
/// ghost triangle behind it, so that every edge has two triangles and no super-triangle is needed.
///
/// Sites are renumbered in insertion order along a Hilbert curve; neighbours lie near in memory. A half-edge is
/// 4 * triangle + k (k = 0, 1, 2): the edge of the triangle from corner k to corner k + 1.
struct Delaunay {
    struct Triangle {
        std::uint32_t corner[3];  // insertion numbers, counter-clockwise; kGhost at most once
        std::uint32_t twin[3];    // the half-edge that runs the other way along edge k
    };
    static constexpr std::uint32_t kGhost = 0xffffffffu;

    RawVector<Vec2> sites;            // distinct, in insertion order
    RawVector<std::uint32_t> seedOf;  // input index of each site
    RawVector<Triangle> triangles;    // with ghosts, 2n - 2 for n sites; ghosts only where all lie on one line
    std::vector<std::array<std::uint32_t, 2>>
        duplicates;  // {input index, input index of the seed it equals}, ascending

    static std::uint32_t triangleOf(std::uint32_t halfEdge) { return halfEdge >> 2; }
    static std::uint32_t next(std::uint32_t halfEdge) { return (halfEdge & 3) == 2 ? halfEdge - 2 : halfEdge + 1; }
    static std::uint32_t previous(std::uint32_t halfEdge) { return (halfEdge & 3) == 0 ? halfEdge + 2 : halfEdge - 1; }
    std::uint32_t origin(std::uint32_t halfEdge) const { return triangles[halfEdge >> 2].corner[halfEdge & 3]; }
    std::uint32_t twin(std::uint32_t halfEdge) const { return triangles[halfEdge >> 2].twin[halfEdge & 3]; }
};

/// Triangulates sites in O(n log n) expected time. Any number, any place: sites on one line are joined by edges with a
/// ghost on either side, equal ones are dropped in favour of the lowest index. Sites on one circle are joined to the one of lowest
/// index (as if its lifted point had been pulled down), so that the result does not depend on the order of insertion.
///
/// Errors: BadInput where a coordinate is not finite, naming the seed; Cancelled.
/// Source: Bowyer 1981; Watson 1981; predicates after Shewchuk 1997.
Result<Delaunay> triangulate(std::span<const Vec2> seeds, const TaskContext& task = {});

/// For each site the half-edge of some triangle that starts at it. Only where there are triangles.
std::vector<std::uint32_t> outgoingHalfEdges(const Delaunay& delaunay);

/// The triangles by input indices: counter-clockwise, smallest index first, sorted.
std::vector<std::array<std::uint32_t, 3>> triangleList(const Delaunay& delaunay);

}  // namespace rubble
