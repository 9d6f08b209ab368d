#pragma once

#include "core/geometry/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// True where a sweep from left to right meets `a` before `b`: by x, then by y.
inline bool sweepsBefore(Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); }

/// A polygon's corners numbered through, the outer ring's first, then each hole's. Corner c also names the edge
/// from it to `next[c]`.
struct NumberedCorners {
    std::vector<Vec2> points;
    std::vector<std::uint32_t> next;
    std::vector<std::uint32_t> previous;
    std::vector<std::uint32_t> ring;         // of each corner; 0 is the outer one
    std::vector<std::uint32_t> firstOfRing;  // rings + 1

    std::uint32_t cornerCount() const { return static_cast<std::uint32_t>(points.size()); }
    std::uint32_t ringCount() const { return static_cast<std::uint32_t>(firstOfRing.size()) - 1; }
};

NumberedCorners numberedCorners(const Polygon& polygon);

/// The numbers of all corners in the order of a sweep; equal points by number.
std::vector<std::uint32_t> sweepOrder(const NumberedCorners& corners);

}  // namespace rubble
