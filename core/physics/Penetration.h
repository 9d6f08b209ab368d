#pragma once

#include "core/physics/BodyScene.h"

#include <cstddef>
#include <span>

namespace rubble {

/// A body as the judge sees it.
struct PlacedHulls {
    std::span<const Polytope> hulls;
    Pose pose;
    bool isFree = true;  // two that nothing moves are not held against each other
};

/// How deep bodies lie in each other: over the pairs of which two hulls overlap, each by the deepest two.
struct Penetration {
    double largest = 0.0;   // m
    double mean = 0.0;      // m
    std::size_t pairs = 0;  // that overlap
};

/// By hullOverlap() on every two hulls whose boxes overlap: exact, and apart from all that the simulation believes.
/// O(n log n) and what overlaps along x.
Penetration penetrationOf(std::span<const PlacedHulls> bodies);

/// The same of a scene whose bodies have moved to `poses`, one a body.
Penetration penetrationOf(const BodyScene& scene, std::span<const Pose> poses);

}  // namespace rubble
