#pragma once

#include "core/base/UninitializedVector.h"
#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The corners of a polygon in space, as indices of points, counter-clockwise seen from where its normal points.
using PointLoop = std::vector<std::uint32_t>;
/// Triangles, as indices of points.
using PointTriangles = UninitializedVector<std::array<std::uint32_t, 3>>;

/// The axis whose coordinate is dropped to see a plane in two dimensions, so that counter-clockwise stays so.
struct PlaneView {
    int right = 0, up = 1;  // axes

    /// The view of planes with a normal: its largest coordinate is dropped.
    explicit PlaneView(Vec3 normal);
    Vec2 operator()(Vec3 point) const { return {point[right], point[up]}; }
};

/// Triangulates a flat polygon by a fan and appends the triangles, if it is convex without straight corners; else does
/// nothing. A triangle is taken as it is. O(n).
bool triangulateConvex(std::span<const Vec3> points, const PointLoop& loop, const PlaneView& view,
                       PointTriangles& triangles);

/// Triangulates a flat polygon, of an outer loop and holes, and appends the triangles. Each edge of a loop is that of
/// one triangle, and each other edge of a triangle is that of two in opposite directions, also where rounding has bent
/// the polygon so that no flawless triangulation exists. O(n log n), O(n²) where rounding has bent it.
void triangulateFace(std::span<const Vec3> points, std::span<const PointLoop> loops, const PlaneView& view,
                     double tolerance, PointTriangles& triangles);

}  // namespace rubble
