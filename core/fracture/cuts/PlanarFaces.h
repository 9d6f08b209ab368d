#pragma once

#include "core/fracture/cuts/PlanarGraph.h"

#include <optional>
#include <span>

namespace rubble {

/// The faces of a planar graph, as a doubly connected edge list (DCEL). Half-edge h runs along edge h / 2: forward if h
/// is even, backward if it is odd; its face lies on its left. Face 0 is the unbounded one.
struct PlanarFaces {
    std::vector<PlanarEdge> edges;
    std::vector<PlanarEdge> dangling;   // removed: the same face lies on both sides
    std::vector<std::uint32_t> next;    // half-edge around the face, of each half-edge
    std::vector<std::uint32_t> faceOf;  // of each half-edge
    std::vector<std::uint32_t>
        ringsBegin;  // faces + 1: offsets in `rings`; a face's outer ring comes first, except of face 0
    std::vector<std::uint32_t> rings;  // a half-edge of each ring

    std::uint32_t count() const { return static_cast<std::uint32_t>(ringsBegin.size()) - 1; }
    std::uint32_t origin(std::uint32_t halfEdge) const {
        const PlanarEdge& edge = edges[halfEdge >> 1];
        return halfEdge & 1 ? edge.to : edge.from;
    }
    /// The piece of the partition on the left of a half-edge; the edge's group is 0.
    std::uint32_t pieceOf(std::uint32_t halfEdge) const {
        return halfEdge & 1 ? edges[halfEdge >> 1].right : edges[halfEdge >> 1].left;
    }
    /// Calls visit(halfEdge) for the half-edges of a face, ring by ring.
    template <class Visit>
    void forEachHalfEdgeOf(std::uint32_t face, Visit visit) const {
        for (std::uint32_t ring = ringsBegin[face]; ring < ringsBegin[face + 1]; ++ring) forEachHalfEdge(ring, visit);
    }
    /// Calls visit(halfEdge) for the half-edges of a ring.
    template <class Visit>
    void forEachHalfEdge(std::uint32_t ring, Visit visit) const {
        std::uint32_t halfEdge = rings[ring];
        do {
            visit(halfEdge);
            halfEdge = next[halfEdge];
        } while (halfEdge != rings[ring]);
    }
};

/// The faces of a graph whose edges meet only at common end points (see splitAtIntersections). Parallel edges are
/// merged; the merged edge is one of the partition if one of them is. Edges are sorted around points by exact signs.
/// Nothing if the graph is not planar: some edges intersect after all.
///
/// Errors: Cancelled.
Result<std::optional<PlanarFaces>> facesOf(const PlanarGraph& graph, const TaskContext& task);

}  // namespace rubble
