#pragma once

#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/search/BoxTree.h"

#include <array>
#include <span>
#include <vector>

namespace rubble {

/// The edges of a polygon in a spatial index, for distances from its boundary. O(n log n) to build; a distance takes
/// O(log n) unless many edges are almost equally near.
class BoundaryDistance {
public:
    explicit BoundaryDistance(const Polygon& polygon);

    /// The distance of a point from the boundary, m: the least distanceToSegment() of the edges.
    double of(Vec2 point) const;
    /// The largest distance of a point of the rings from the boundary, m.
    double largestOf(std::span<const Ring> rings) const;

private:
    using Edge = std::array<Vec2, 2>;

    std::vector<Edge> m_edges;
    BoxTree m_tree;
};

/// The Hausdorff distance of the corners of each polygon from the other's boundary, m.
double distanceBetween(const Polygon& a, const Polygon& b);

}  // namespace rubble
