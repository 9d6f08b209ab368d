#pragma once

#include "core/base/RawVector.h"
#include "core/fracture/OutlineTrace.h"
#include "core/geometry/PointFrame.h"

#include <cstdint>

namespace rubble {

/// How points of a partition over a triangulation are numbered: a Voronoi corner has its triangle's number, then come the
/// outline's vertices, then the crossings.
struct PointNumbers {
    std::uint32_t vertices = 0;   // number of the first outline vertex
    std::uint32_t crossings = 0;  // number of the first crossing
    std::uint32_t count = 0;
};
PointNumbers pointNumbers(const Delaunay& delaunay, const OutlineTrace& trace);

/// The Voronoi corners, each rounded once, relative to the frame; of ghost triangles, infinity. Writes them to the first
/// places of `points`, in up to `threads` threads at a time.
void computeCorners(const Delaunay& delaunay, const PointFrame& frame, int threads, RawVector<Vec2>& points);

/// Writes the outline's vertices and crossings behind the corners.
void computeOutlinePoints(const Delaunay& delaunay, const OutlineTrace& trace, const PointFrame& frame,
                          RawVector<Vec2>& points);

}  // namespace rubble
