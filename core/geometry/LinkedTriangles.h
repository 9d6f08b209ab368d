#pragma once

#include "core/geometry/SweepTriangulation.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rubble {

/// Triangles that know their neighbours. Half-edge 3t + k runs from corner k of triangle t to corner k + 1.
struct LinkedTriangles {
    static constexpr std::uint32_t kBoundary = 0xffffffffu;

    std::vector<std::uint32_t> origin;  // corner at which each half-edge starts
    std::vector<std::uint32_t> twin;    // the half-edge that runs the other way; kBoundary along the polygon's edges

    static std::uint32_t next(std::uint32_t halfEdge) { return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1; }
    static std::uint32_t previous(std::uint32_t halfEdge) { return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1; }
    std::uint32_t halfEdgeCount() const { return static_cast<std::uint32_t>(origin.size()); }
};

/// Links triangles of positive area that fill a polygon whose inner points the rings wind around once. Nothing where they
/// do not fill it: where an inner edge lacks its twin, or an edge of the polygon is not had by exactly one triangle.
std::optional<LinkedTriangles> linked(const std::vector<CornerTriangle>& triangles, const NumberedCorners& corners);

/// Flips inner edges until each is locally Delaunay: the constrained Delaunay triangulation of the polygon.
/// Cocircular corners stay as they are. Exact, so that it ends; O(n^2) flips at worst, about n on common outlines.
/// Source: Lawson 1977.
void makeDelaunay(LinkedTriangles& triangles, std::span<const Vec2> points);

}  // namespace rubble
