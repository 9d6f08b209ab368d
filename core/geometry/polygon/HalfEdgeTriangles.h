#pragma once

#include "core/geometry/polygon/SweepTriangulation.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// A triangulation with half-edge adjacency. Half-edge 3t + k runs from corner k of triangle t to corner k + 1.
struct HalfEdgeTriangles {
    std::vector<std::uint32_t> origin;  // the corner where each half-edge starts
    std::vector<std::uint32_t> twin;    // the opposite half-edge; kNone on the polygon's boundary

    static std::uint32_t next(std::uint32_t halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }
    static std::uint32_t previous(std::uint32_t halfEdge) { return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1; }
    std::uint32_t halfEdgeCount() const { return static_cast<std::uint32_t>(origin.size()); }
};

/// Links the triangles of a triangulation of a polygon. Nothing if they do not fill it: if an inner edge has no twin,
/// or an edge of the polygon does not belong to exactly one triangle. Triangles must have positive area.
std::optional<HalfEdgeTriangles> linkTriangles(const std::vector<CornerTriangle>& triangles,
                                               const IndexedCorners& corners);

/// Flips inner edges until all are locally Delaunay, which gives the constrained Delaunay triangulation of the polygon.
/// Edges of cocircular corners are kept. By exact predicates, so that it terminates; O(n^2) flips at worst, typically
/// about n. Returns the number of tested edges.
/// Source: Lawson 1977.
std::size_t makeDelaunay(HalfEdgeTriangles& triangles, std::span<const Vec2> points);

}  // namespace rubble
