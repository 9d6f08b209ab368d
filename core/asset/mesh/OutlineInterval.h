#pragma once

#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/search/BoxTree.h"

#include <vector>

namespace rubble {

/// The position of an edge along an outline, which gives the texture coordinates of sides.
struct OutlineInterval {
    double from = 0.0;      // m along the ring where the edge starts; increases in the edge's direction
    double to = 0.0;        // m
    double distance = 0.0;  // m from the edge's midpoint to the outline
};

/// The edges of an outline, indexed for searches.
class OutlineIndex {
public:
    explicit OutlineIndex(const Polygon& outline);

    /// The interval along the edge, of any ring, that is nearest to the midpoint of the edge from `a` to `b`, the first
    /// of equally near ones. Lengths start at each ring's first corner. O(log corners); adds the number of visited
    /// edges to `visited`.
    OutlineInterval nearestInterval(Vec2 a, Vec2 b, std::size_t* visited = nullptr) const;

private:
    struct Edge {
        Vec2 start{0.0, 0.0};
        Vec2 direction{1.0, 0.0};  // unit length
        double length = 0.0;
        double before = 0.0;  // length of the ring before the edge

        double along(Vec2 point) const { return before + glm::dot(point - start, direction); }
    };

    void addRing(const Ring& ring, std::vector<Box3>& boxes);
    static std::vector<Box3> boxesOf(const Polygon& outline, OutlineIndex& index);

    std::vector<Edge> m_edges;
    BoxTree m_tree;
};

}  // namespace rubble
