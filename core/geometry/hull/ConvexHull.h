#pragma once

#include "core/base/Result.h"
#include "core/geometry/hull/Polytope.h"

#include <span>

namespace rubble {

/// The convex hull of points, by exact predicates. Coplanar triangles are merged to faces; points in the interior of a
/// face or edge are not vertices. Vertices keep the input order; faces start at their lowest vertex; faces and edges
/// are sorted.
///
/// Errors: BadInput for fewer than four points or a coordinate that is not finite or not exactly usable (see
/// Predicates.h), naming the point; Degenerate if all points are coplanar.
/// Source: Barber, Dobkin, Huhdanpaa 1996.
Result<Polytope> convexHull(std::span<const Vec3> points);

/// The same for points that are known within a tolerance, m: neighbouring triangles are one face if no corner is
/// farther from the plane of the largest than that, so that faces of points that are coplanar but for rounding have no
/// needles beside them, which would turn over where the hull is moved. Corners that are left with two faces are no
/// vertices. Where faces cannot be merged so, the hull is that of the points as they are.
///
/// Errors: those above.
Result<Polytope> convexHull(std::span<const Vec3> points, double tolerance);

/// That tolerance for points that are rounded, m: of what is flat but for that.
double flatnessOf(std::span<const Vec3> points);

}  // namespace rubble
