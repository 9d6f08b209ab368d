#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The corners of a polygon in one list, the outer ring's first, then each hole's. Index c also denotes the edge from
/// corner c to `next[c]`.
struct IndexedCorners {
    std::vector<Vec2> points;
    std::vector<std::uint32_t> next;
    std::vector<std::uint32_t> previous;
    std::vector<std::uint32_t> ring;         // of each corner; 0 is the outer ring
    std::vector<std::uint32_t> firstOfRing;  // per ring, and the end

    std::uint32_t cornerCount() const { return static_cast<std::uint32_t>(points.size()); }
    std::uint32_t ringCount() const { return static_cast<std::uint32_t>(firstOfRing.size()) - 1; }
};

/// The corners of a polygon.
IndexedCorners indexedCorners(const Polygon& polygon);

/// The indices of all corners in sweep order: by x, then y, then index.
std::vector<std::uint32_t> sweepOrder(const IndexedCorners& corners);

/// An edge, from the end that a sweep in that order reaches first.
struct SweptEdge {
    Vec2 left;
    Vec2 right;
    bool runsRight = false;  // whether its ring runs from left to right along it
};

/// The edges of a polygon, by the corner at which they start.
std::vector<SweptEdge> sweptEdges(const IndexedCorners& corners);

/// Whether edge `a` is below `b` where the sweep line meets both, which do not cross. Edges that touch there are
/// equivalent.
bool isBelow(const SweptEdge& a, const SweptEdge& b);

}  // namespace rubble
