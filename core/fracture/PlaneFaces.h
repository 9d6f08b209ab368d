#pragma once

#include "core/fracture/PlaneEdges.h"

#include <optional>
#include <span>

namespace rubble {

/// The areas that edges enclose. Half-edge h runs along edge h / 2: forward where h is even, back where it is odd; its face lies on
/// its left. Face 0 is what lies around everything.
struct PlaneFaces {
    std::vector<PlaneEdge> edges;
    std::vector<PlaneEdge>
        loose;  // edges that part nothing from nothing: they have one face on both sides and are left out
    std::vector<std::uint32_t> next;        // of each half-edge, the next one around its face
    std::vector<std::uint32_t> faceOf;      // of each half-edge
    std::vector<std::uint32_t> ringsBegin;  // faces + 1: which `rings` are a face's; but for face 0 the outer one first
    std::vector<std::uint32_t> rings;       // a half-edge of each

    std::uint32_t count() const { return static_cast<std::uint32_t>(ringsBegin.size()) - 1; }
    std::uint32_t origin(std::uint32_t halfEdge) const {
        const PlaneEdge& edge = edges[halfEdge >> 1];
        return halfEdge & 1 ? edge.to : edge.from;
    }
    /// The piece of the partition that a half-edge bounds: only where the edge's group is 0.
    std::uint32_t pieceOf(std::uint32_t halfEdge) const {
        return halfEdge & 1 ? edges[halfEdge >> 1].right : edges[halfEdge >> 1].left;
    }
    template <class Visit>
    void forEachHalfEdge(std::uint32_t ring, Visit visit) const {
        std::uint32_t halfEdge = rings[ring];
        do {
            visit(halfEdge);
            halfEdge = next[halfEdge];
        } while (halfEdge != rings[ring]);
    }
};

/// The faces of a drawing whose edges share all points in which they meet (see partAtMeetings). Edges between the same two points
/// become one, of a partition's if one of them is. Which way edges run around a point is decided by exact signs. None where
/// the drawing cannot lie in a plane that way: some edges meet elsewhere after all.
///
/// Errors: Cancelled.
Result<std::optional<PlaneFaces>> facesOf(const PlaneDrawing& drawing, const TaskContext& task);

}  // namespace rubble
