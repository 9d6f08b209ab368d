#include "core/geometry/polygon/ContainmentIndex.h"

#include "core/geometry/polygon/RayCrossings.h"

namespace rubble {

ContainmentIndex::ContainmentIndex(const Polygon& polygon) : m_edges(edgesOf(polygon)), m_tree(boxesOf(m_edges)) {}

Containment ContainmentIndex::of(Vec2 point, std::size_t* visited) const {
    // Holes are inside the outline and apart: the crossings of all rings give the same as those of each.
    RayCrossings crossings;
    std::size_t count = 0;
    m_tree.visitOverlapping({Vec3(point, 0.0), Vec3(1e308, point.y, 0.0)}, [&](std::uint32_t k) {
        crossings.add(m_edges[k][0], m_edges[k][1], point);
        ++count;
    });
    if (visited) *visited += count;
    if (crossings.isOnEdge) return Containment::OnBoundary;
    return crossings.isOdd ? Containment::Inside : Containment::Outside;
}

}  // namespace rubble
