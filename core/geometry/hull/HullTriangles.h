#pragma once

#include "core/base/Result.h"
#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A triangle of a convex hull, counter-clockwise from outside.
struct HullTriangle {
    std::array<std::uint32_t, 3> corners{};     // indices of input points
    std::array<std::uint32_t, 3> neighbours{};  // the triangle across the edge from corner i to the next
};

/// The convex hull of points as triangles, several of which may be coplanar. By exact predicates: no point is outside
/// any triangle. O(n log n) expected for n points.
///
/// Errors: BadInput for fewer than four points or a coordinate that is not finite or not exactly usable (see
/// Predicates.h), naming the point; Degenerate if all points are coplanar.
/// Source: Barber, Dobkin, Huhdanpaa 1996 (quickhull). A point in the plane of a face does not see it.
Result<std::vector<HullTriangle>> hullTriangles(std::span<const Vec3> points);

}  // namespace rubble
