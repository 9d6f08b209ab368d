#pragma once

#include "core/base/Index.h"
#include "core/base/RawVector.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/OutlineTips.h"
#include "core/geometry/PointFrame.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A straight edge between two points of a drawing in the plane.
struct PlaneEdge {
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::uint32_t group = 0;     // 0: edges of a partition; else cuts of one layer
    std::uint32_t line = kNone;  // of its layer
    std::uint32_t left = kNone;  // these two where the group is 0: pieces of the partition; kNone: outside the outline
    std::uint32_t right = kNone;
};

/// Points, and edges that may meet anyhow.
struct PlaneDrawing {
    RawVector<Vec2> points;  // relative to the frame
    std::vector<PlaneEdge> edges;
    std::vector<bool> isNodedGroup;            // of each group: its edges share all points in which they meet
    std::vector<std::uint32_t> outlineVertex;  // of the first points; kNone: no corner of the outline
    PointFrame frame;

    std::uint32_t vertexOf(std::uint32_t point) const {
        return point < outlineVertex.size() ? outlineVertex[point] : kNone;
    }
};

/// Parts edges where they meet: after it they share all points that they have in common. New points are computed from
/// two edges and rounded once. What is nearer than the frame's joinDistance is one: of two points the outline's corner stays,
/// else the lower one; an edge that passes a point so near goes through it. The outline's corners keep their place, and what
/// comes into the tip of a sharp one (see OutlineTips) goes to it. Edges without length are left out.
///
/// Errors: Degenerate where this comes to no end; Cancelled.
Status partAtMeetings(const OutlineTips& tips, const TaskContext& task, PlaneDrawing& drawing);

}  // namespace rubble
