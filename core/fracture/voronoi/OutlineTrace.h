#pragma once

#include "core/base/Index.h"
#include "core/base/Result.h"
#include "core/fracture/voronoi/PerturbedDiagram.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A point where the outline passes from one Voronoi cell into the next.
struct OutlineCrossing {
    std::uint32_t halfEdge;  // from the site of the cell that is left to that of the cell that is entered
    std::uint32_t edge;      // of the outline: its first vertex
    std::uint32_t edgeEnd;   // that edge's other vertex
};

/// A stretch of the outline inside one cell, from the crossing where it enters to the one where it leaves.
struct BoundaryArc {
    std::uint32_t cell;   // site
    std::uint32_t enter;  // crossing; kNone if the whole ring lies inside the cell
    std::uint32_t leave;  // crossing; kNone where `enter` is
    std::uint32_t ring;
    std::uint32_t firstVertex;  // further ones follow around the ring
    std::uint32_t vertexCount;  // may be 0
    std::uint32_t nextInCell;   // next arc in the same cell, or kNone
};

/// The course of an outline through the Voronoi cells, ring by ring.
struct OutlineTrace {
    std::vector<Vec2> vertices;             // of all rings: the outer one, then the holes
    std::vector<std::uint32_t> ringStarts;  // rings + 1
    std::vector<OutlineCrossing> crossings;
    std::vector<BoundaryArc> arcs;
    std::vector<std::uint32_t> firstArc;  // of each site; kNone if the outline does not enter its cell

    DirectedLine lineOf(const OutlineCrossing& crossing) const {
        return {vertices[crossing.edge], vertices[crossing.edgeEnd]};
    }
};

/// The maximum number of places where an outline crosses cells: a piece may lie behind each.
inline constexpr std::size_t kMaxOutlineCrossings = 8'000'000;

/// Traces a canonical outline through the cells of a triangulation with at least two sites. All signs are those of the
/// perturbed diagram, so every ring returns to the cell in which it started.
/// O(sqrt(n) + cells visited + vertices), expected.
///
/// Errors: Limit above kMaxOutlineCrossings.
Result<OutlineTrace> traceOutline(const Polygon& outline, const Delaunay& delaunay,
                                  const std::vector<std::uint32_t>& outgoing);

/// The next half-edge counter-clockwise around the same site.
inline std::uint32_t nextAround(const Delaunay& delaunay, std::uint32_t halfEdge) {
    return delaunay.twin(Delaunay::previous(halfEdge));
}
/// The site at the end of a half-edge, or the ghost.
inline std::uint32_t targetOf(const Delaunay& delaunay, std::uint32_t halfEdge) {
    return delaunay.origin(Delaunay::next(halfEdge));
}

}  // namespace rubble
