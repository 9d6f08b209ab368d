#pragma once

#include "core/base/Result.h"
#include "core/geometry/Vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A triangle of a hull's surface, counter-clockwise from outside.
struct HullTriangle {
    std::array<std::uint32_t, 3> corners{};     // input points
    std::array<std::uint32_t, 3> neighbours{};  // triangle across the edge from corner i to the next
};

/// The surface of the smallest convex body around the points, in triangles of which several may be coplanar. No point
/// lies outside any of them: every sign is exact. O(n log n) expected for n points.
///
/// Errors: BadInput for fewer than four points or a coordinate that is not finite or not exactly usable (see
/// Predicates.h), naming the point; Degenerate where all points lie in one plane.
/// Source: Barber, Dobkin, Huhdanpaa 1996; a point in the plane of a face does not see it.
Result<std::vector<HullTriangle>> hullTriangles(std::span<const Vec3> points);

}  // namespace rubble
