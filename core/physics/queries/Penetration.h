#pragma once

#include "core/geometry/hull/Polytope.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A body for measuring overlaps.
struct PosedHulls {
    std::span<const Polytope> hulls;
    Pose pose;
    bool isDynamic = true;  // overlaps of two bodies that are not dynamic are ignored
};

/// The depths at which bodies overlap, over all pairs of overlapping bodies; the depth of a pair is that of its two
/// deepest hulls.
struct Penetration {
    double largest = 0.0;   // m
    double mean = 0.0;      // m
    std::size_t pairs = 0;  // of overlapping bodies
};

/// Two overlapping bodies, first < second.
struct BodyOverlap {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    double depth = 0.0;  // m, of the two deepest hulls
};

/// All pairs of overlapping bodies, ascending, by hullOverlap() of all pairs of hulls whose bounding boxes overlap:
/// independent of the simulation's own collision detection. O(n log n + k) for k pairs of hulls that overlap along x;
/// adds k to `compared`.
std::vector<BodyOverlap> overlapsOf(std::span<const PosedHulls> bodies, std::size_t* compared = nullptr);

/// The largest and mean depth of overlapsOf().
Penetration penetrationOf(std::span<const PosedHulls> bodies);

}  // namespace rubble
