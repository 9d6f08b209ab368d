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

}  // namespace rubble
