#pragma once

#include "core/base/Index.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/base/UninitializedVector.h"
#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The ghost vertex at infinity.
inline constexpr std::uint32_t kGhost = kNone;

/// The Delaunay triangulation of sites, closed by one ghost vertex at infinity: behind every edge of the convex hull is
/// a ghost triangle, so that every edge has two triangles and no super-triangle is needed.
///
/// Sites are numbered along a Hilbert curve, so that neighbours are close in memory. Half-edge 4 * triangle + k
/// (k = 0, 1, 2) is the edge of the triangle from corner k to corner k + 1.
struct Delaunay {
    struct Triangle {
        std::uint32_t corner[3];  // sites, counter-clockwise; kGhost at most once
        std::uint32_t twin[3];    // the opposite half-edge of edge k

        /// Whether a corner is the ghost vertex.
        bool isGhost() const { return corner[0] == kGhost || corner[1] == kGhost || corner[2] == kGhost; }
    };

    UninitializedVector<Vec2> sites;            // distinct
    UninitializedVector<std::uint32_t> seedOf;  // input index of each site
    UninitializedVector<Triangle>
        triangles;  // with ghosts, 2n - 2 for n sites; all are ghosts if all sites are collinear
    std::vector<std::array<std::uint32_t, 2>>
        duplicates;  // {input index, input index of the seed it equals}, ascending

    static std::uint32_t triangleOf(std::uint32_t halfEdge) { return halfEdge >> 2; }
    static std::uint32_t next(std::uint32_t halfEdge) { return (halfEdge & 3) == 2 ? halfEdge - 2 : halfEdge + 1; }
    static std::uint32_t previous(std::uint32_t halfEdge) { return (halfEdge & 3) == 0 ? halfEdge + 2 : halfEdge - 1; }
    std::uint32_t origin(std::uint32_t halfEdge) const { return triangles[halfEdge >> 2].corner[halfEdge & 3]; }
    std::uint32_t twin(std::uint32_t halfEdge) const { return triangles[halfEdge >> 2].twin[halfEdge & 3]; }
};

/// Triangulates any number of seeds in O(n log n) expected time. Collinear sites are connected by edges with a ghost on
/// either side; of equal seeds, the one with the lowest index is kept. Cocircular sites are all connected to the one
/// with the lowest index (as if its lifted point were infinitesimally lower), so that the result does not depend on the
/// insertion order.
///
/// Errors: BadInput if a coordinate is not finite, naming the seed; Cancelled.
/// Source: Bowyer 1981; Watson 1981; predicates after Shewchuk 1997.
Result<Delaunay> triangulate(std::span<const Vec2> seeds, const TaskContext& task = {});

/// A half-edge that starts at each site. There must be triangles.
std::vector<std::uint32_t> outgoingHalfEdges(const Delaunay& delaunay);

/// The triangles as seed indices: counter-clockwise, smallest index first, sorted.
std::vector<std::array<std::uint32_t, 3>> triangleList(const Delaunay& delaunay);

}  // namespace rubble
