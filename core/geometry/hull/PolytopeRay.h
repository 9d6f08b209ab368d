#pragma once

#include "core/geometry/hull/Polytope.h"
#include "core/geometry/hull/Ray.h"

#include <optional>

namespace rubble {

/// The point where a ray enters a polytope.
struct PolytopeRayHit {
    double distance = 0.0;  // m, >= 0
    Vec3 normal{0.0, 1.0, 0.0};
};

/// Casts a ray in the polytope's frame. Nothing if it misses the polytope or begins inside.
/// Source: Cyrus, Beck 1978.
std::optional<PolytopeRayHit> castRay(const Polytope& polytope, const Ray& ray);

}  // namespace rubble
