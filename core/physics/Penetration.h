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

/// Two bodies that lie in each other: their numbers, ascending, and how deep.
struct BodyOverlap {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    double depth = 0.0;  // m, of the deepest two of their hulls
};

/// Every two bodies that overlap, ascending. By hullOverlap() on every two hulls whose boxes overlap: exact, and apart from
/// all that the simulation believes. O(n log n) and what overlaps along x.
std::vector<BodyOverlap> overlapsOf(std::span<const PlacedHulls> bodies);

/// The same, summed up.
Penetration penetrationOf(std::span<const PlacedHulls> bodies);

/// The same of a scene whose bodies have moved to `poses`, one a body.
Penetration penetrationOf(const BodyScene& scene, std::span<const Pose> poses);

}  // namespace rubble
