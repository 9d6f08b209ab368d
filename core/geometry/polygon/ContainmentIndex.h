#pragma once

#include "core/geometry/polygon/Polygon.h"
#include "core/geometry/search/BoxTree.h"

#include <array>
#include <cstddef>
#include <vector>

namespace rubble {

/// The edges of a valid polygon in a spatial index, for the containment of many points. O(n log n) to build; a point
/// takes O(log n), and the edges whose boxes a ray from it to the right meets.
class ContainmentIndex {
public:
    explicit ContainmentIndex(const Polygon& polygon);

    /// The same as containment(); adds the number of examined edges to `visited`.
    Containment of(Vec2 point, std::size_t* visited = nullptr) const;
    /// Whether `meets(from, to)` is true of an edge whose box overlaps or touches a box.
    template <class Meets>
    bool hasEdge(Vec2 low, Vec2 high, Meets meets) const {
        bool isFound = false;
        m_tree.visitOverlapping({Vec3(low, 0.0), Vec3(high, 0.0)},
                                [&](std::uint32_t k) { isFound = isFound || meets(m_edges[k][0], m_edges[k][1]); });
        return isFound;
    }

private:
    using Edge = std::array<Vec2, 2>;

    std::vector<Edge> m_edges;
    BoxTree m_tree;
};

}  // namespace rubble
