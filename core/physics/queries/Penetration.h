#pragma once

#include "core/geometry/hull/Polytope.h"

#include <cstddef>
#include <cstdint>
#include <limits>
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

/// What overlapsOf() looks for, and what it did.
struct OverlapSearch {
    double least = 0.0;                                          // m: only deeper overlaps count
    std::size_t most = std::numeric_limits<std::size_t>::max();  // hulls that overlap; it ends when it finds more
    std::size_t compared = 0;                                    // pairs of hulls whose bounding boxes overlap
    bool isComplete = true;                                      // there are no more than `most`
};

/// All pairs of overlapping bodies, ascending, by hullOverlap() of all pairs of hulls whose bounding boxes overlap:
/// independent of the simulation's own collision detection. O(n log n + k) for k pairs of hulls whose boxes overlap.
std::vector<BodyOverlap> overlapsOf(std::span<const PosedHulls> bodies);
std::vector<BodyOverlap> overlapsOf(std::span<const PosedHulls> bodies, OverlapSearch& search);

/// The largest and mean depth of overlapsOf().
Penetration penetrationOf(std::span<const PosedHulls> bodies);

}  // namespace rubble
