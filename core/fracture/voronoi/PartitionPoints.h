#pragma once

#include "core/base/UninitializedVector.h"
#include "core/fracture/voronoi/OutlineTrace.h"
#include "core/geometry/polygon/LocalFrame.h"

#include <cstdint>

namespace rubble {

/// The numbering of a partition's points: first the Voronoi corners, with the numbers of their triangles, then the
/// outline's vertices, then the crossings.
struct PointNumbers {
    std::uint32_t vertices = 0;   // number of the first outline vertex
    std::uint32_t crossings = 0;  // number of the first crossing
    std::uint32_t count = 0;
};
PointNumbers pointNumbers(const Delaunay& delaunay, const OutlineTrace& trace);

/// Writes the Voronoi corners, each rounded once, relative to the frame (infinity for ghost triangles), to the front of
/// `points`, on up to `threads` threads.
void computeCorners(const Delaunay& delaunay, const LocalFrame& frame, int threads, UninitializedVector<Vec2>& points);

/// Writes the outline's vertices and crossings after the corners.
void computeOutlinePoints(const Delaunay& delaunay, const OutlineTrace& trace, const LocalFrame& frame,
                          UninitializedVector<Vec2>& points);

}  // namespace rubble
