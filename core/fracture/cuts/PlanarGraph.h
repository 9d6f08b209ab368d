#pragma once

#include "core/base/Index.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/base/UninitializedVector.h"
#include "core/fracture/voronoi/AcuteCorners.h"
#include "core/geometry/polygon/LocalFrame.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The maximum number of places where edges of a planar graph intersect, so that the overlay fits into a few gigabytes:
/// more than 2000 cuts across 2000 others have.
inline constexpr std::size_t kMaxIntersections = 5'000'000;

/// A straight edge of a planar graph.
struct PlanarEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t group = 0;     // 0: edges of a partition; else the cuts of one layer
    std::uint32_t line = kNone;  // of its layer
    std::uint32_t left = kNone;  // and right: pieces if the group is 0; kNone: outside the outline
    std::uint32_t right = kNone;
};

/// Points and straight edges, which may intersect until splitAtIntersections().
struct PlanarGraph {
    UninitializedVector<Vec2> points;  // relative to the frame
    std::vector<PlanarEdge> edges;
    std::vector<bool> isNodedGroup;            // of each group: its edges meet only at common end points
    std::vector<std::uint32_t> outlineVertex;  // of the first points; kNone: no vertex of the outline
    LocalFrame frame;

    std::uint32_t vertexOf(std::uint32_t point) const {
        return point < outlineVertex.size() ? outlineVertex[point] : kNone;
    }
};

/// Splits edges at their intersections, so that they meet only at common end points (noding). New points are computed
/// from two edges and rounded once. Points closer than the frame's weldDistance are welded: an outline vertex stays,
/// otherwise the lower point; an edge that passes a point that closely is split there. Outline vertices do not move,
/// and points in an acute corner region (see AcuteCorners) are welded to its vertex. Edges of zero length are removed.
///
/// Errors: Degenerate if this does not converge; Limit above kMaxIntersections; Cancelled.
Status splitAtIntersections(const AcuteCorners& acuteCorners, const TaskContext& task, PlanarGraph& graph);

}  // namespace rubble
