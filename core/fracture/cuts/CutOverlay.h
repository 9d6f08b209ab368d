#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/cuts/PlanarFaces.h"
#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/Polygon.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace rubble {

/// The planar overlay of cuts with the pieces near them.
struct CutOverlay {
    static constexpr std::uint32_t kUnknown = kNone - 1;

    PlanarFaces faces;
    UninitializedVector<Vec2> points;        // those of the partition first
    std::vector<std::uint32_t> pieceOfFace;  // a piece of the partition; kNone: outside the outline; or kUnknown
    std::vector<bool> isCut;                 // of the pieces of the partition; the others have no faces
    std::map<std::array<std::uint32_t, 2>, std::uint32_t>
        faceBehindEdge;  // of edges {from, to} of pieces that are not cut

    /// Whether a face belongs to a piece that is cut.
    bool isInCutPiece(std::uint32_t face) const { return pieceOfFace[face] < kUnknown && isCut[pieceOfFace[face]]; }
};

/// Overlays cuts with a partition of a validated() outline. O(n log n) for cuts that intersect few others.
///
/// Errors: Degenerate if cuts cannot be distinguished; Limit above kMaxIntersections; Cancelled.
Result<CutOverlay> overlayCuts(const Partition& partition, const Polygon& outline, const CutSet& cuts,
                               const TaskContext& task);

}  // namespace rubble
