#pragma once

#include "core/geometry/Polytope.h"
#include "core/geometry/Ray.h"

#include <optional>

namespace rubble {

/// Where a ray enters a polytope.
struct PolytopeEntry {
    double distance = 0.0;  // m, >= 0
    Vec3 normal{0.0, 1.0, 0.0};
};

/// Both in the polytope's frame. Nothing where the ray misses it, or begins inside.
/// Source: Cyrus, Beck 1978.
std::optional<PolytopeEntry> entryOf(const Polytope& polytope, const Ray& ray);

}  // namespace rubble
