#pragma once

#include "core/base/RawVector.h"
#include "core/fracture/OutlineTrace.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// How points of a partition over a triangulation are numbered: a Voronoi corner has its triangle's number, then come the
/// outline's vertices, then the crossings.
struct PointNumbers {
    std::uint32_t vertices = 0;   // number of the first outline vertex
    std::uint32_t crossings = 0;  // number of the first crossing
    std::uint32_t count = 0;
};
PointNumbers pointNumbers(const Delaunay& delaunay, const OutlineTrace& trace);

/// Where points are measured from, and how far they lie from there.
struct PointFrame {
    Vec2 origin{0.0, 0.0};
    double reach = 0.0;         // the outline's largest coordinate relative to the origin
    double joinDistance = 0.0;  // points that are nearer in x and in y are one

    bool areOne(Vec2 a, Vec2 b) const {
        return std::abs(a.x - b.x) <= joinDistance && std::abs(a.y - b.y) <= joinDistance;
    }
};

/// The frame for an outline. Subtracting its origin from the outline's points does not round.
PointFrame frameOf(const Polygon& outline);

/// The Voronoi corners, each rounded once, relative to the frame; of ghost triangles, infinity. Writes them to the first
/// places of `points`, in up to `threads` threads at a time.
void computeCorners(const Delaunay& delaunay, const PointFrame& frame, int threads, RawVector<Vec2>& points);

/// Writes the outline's vertices and crossings behind the corners.
void computeOutlinePoints(const Delaunay& delaunay, const OutlineTrace& trace, const PointFrame& frame,
                          RawVector<Vec2>& points);

/// Triangles side by side whose corners are one point, as those on one circle are.
std::vector<std::array<std::uint32_t, 2>> coincidentCorners(const Delaunay& delaunay, const PointFrame& frame,
                                                            int threads, const RawVector<Vec2>& points);

}  // namespace rubble
