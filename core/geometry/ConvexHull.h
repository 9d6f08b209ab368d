#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polytope.h"

#include <span>

namespace rubble {

/// The smallest convex polytope around the points. Coplanar triangles are joined to one face, points inside
/// a face or an edge are left out; every sign is exact. Vertices keep the order of the input; faces begin at their
/// smallest vertex and are sorted, as are edges.
///
/// Errors: BadInput for fewer than four points or a coordinate that is not finite or not exactly usable (see
/// Predicates.h), naming the point; Degenerate where all points lie in one plane.
/// Source: Barber, Dobkin, Huhdanpaa 1996.
Result<Polytope> convexHull(std::span<const Vec3> points);

}  // namespace rubble
