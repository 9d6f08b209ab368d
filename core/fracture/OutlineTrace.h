#pragma once

#include "core/fracture/PerturbedDiagram.h"
#include "core/fracture/Report.h"
#include "core/geometry/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Where the outline goes from one Voronoi cell into the next.
struct OutlineCrossing {
    std::uint32_t halfEdge;  // starts at the site whose cell is left, ends at that of the cell that is entered
    std::uint32_t edge;      // of the outline, named by its first vertex
    std::uint32_t edgeEnd;   // that edge's other vertex
};

/// A stretch of the outline inside one cell, from the crossing where it enters to the one where it leaves.
struct OutlinePassage {
    std::uint32_t cell;   // site
    std::uint32_t enter;  // crossing; kNone where the whole ring lies inside the cell
    std::uint32_t leave;  // crossing; kNone likewise
    std::uint32_t ring;
    std::uint32_t firstVertex;  // then on round the ring
    std::uint32_t vertexCount;  // may be 0
    std::uint32_t nextInCell;   // next passage of the same cell, or kNone
};

/// An outline followed through the Voronoi cells, ring by ring.
struct OutlineTrace {
    std::vector<Vec2> vertices;             // of all rings: the outer one, then the holes
    std::vector<std::uint32_t> ringStarts;  // rings + 1
    std::vector<OutlineCrossing> crossings;
    std::vector<OutlinePassage> passages;
    std::vector<std::uint32_t> firstPassage;  // of each site; kNone where the outline does not enter its cell

    DirectedLine lineOf(const OutlineCrossing& crossing) const {
        return {vertices[crossing.edge], vertices[crossing.edgeEnd]};
    }
};

/// Follows a canonical outline through the cells of a triangulation with at least two sites. All signs come from the
/// perturbed diagram, so every ring comes back to the cell it started in.
/// O(sqrt(n) + cells visited + vertices), expected.
OutlineTrace traceOutline(const Polygon& outline, const Delaunay& delaunay, const std::vector<std::uint32_t>& outgoing);

/// The half-edge that follows counter-clockwise among those which start at the same site.
inline std::uint32_t nextAround(const Delaunay& delaunay, std::uint32_t halfEdge) {
    return delaunay.twin(Delaunay::previous(halfEdge));
}
/// The site at the half-edge's end, or the ghost.
inline std::uint32_t targetOf(const Delaunay& delaunay, std::uint32_t halfEdge) {
    return delaunay.origin(Delaunay::next(halfEdge));
}

}  // namespace rubble
