#pragma once

#include "core/physics/shape/Hull.h"

namespace rubble {

/// The point at which a segment enters a hull.
struct HullRayHit {
    float fraction = 2.0f;  // of the segment; above 1 if it misses or begins inside
    Vec3f normal{0.0f, 0.0f, 0.0f};
};

/// Casts a ray from `from` to `from + displacement`, in the hull's frame.
/// Source: Cyrus, Beck 1978.
HullRayHit castRay(const Hull& hull, Vec3f from, Vec3f displacement);

}  // namespace rubble
