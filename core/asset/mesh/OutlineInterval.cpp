#include "core/asset/mesh/OutlineInterval.h"

#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rubble {

OutlineIndex::OutlineIndex(const Polygon& outline) : m_tree(boxesOf(outline, *this)) {}

std::vector<Box3> OutlineIndex::boxesOf(const Polygon& outline, OutlineIndex& index) {
    std::vector<Box3> boxes;
    index.addRing(outline.outer, boxes);
    for (const Ring& hole : outline.holes) index.addRing(hole, boxes);
    return boxes;
}

void OutlineIndex::addRing(const Ring& ring, std::vector<Box3>& boxes) {
    double before = 0.0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2 next = ring[i + 1 < ring.size() ? i + 1 : 0], edge = next - ring[i];
        const double length = glm::length(edge);
        if (!(length > 0.0)) continue;
        m_edges.push_back({ring[i], edge / length, length, before});
        before += length;
        boxes.push_back(boxOf(ring[i], next));
    }
}

OutlineInterval OutlineIndex::nearestInterval(Vec2 a, Vec2 b, std::size_t* visited) const {
    const Vec2 middle = a + 0.5 * (b - a);
    double least = std::numeric_limits<double>::infinity();
    std::uint32_t nearest = kNone;
    const std::size_t count = m_tree.visitNear(Vec3(middle, 0.0), [&](std::uint32_t k) {
        const Edge& edge = m_edges[k];
        const double along = std::clamp(glm::dot(middle - edge.start, edge.direction), 0.0, edge.length);
        const double distance = glm::distance(middle, edge.start + along * edge.direction);
        if (distance < least || (distance == least && k < nearest)) {
            least = distance;
            nearest = k;
        }
        return least;
    });
    if (visited) *visited += count;
    const Edge edge = nearest == kNone ? Edge{} : m_edges[nearest];
    // A clockwise outline is measured backwards, so that textures are not mirrored.
    const double sign = glm::dot(b - a, edge.direction) < 0.0 ? -1.0 : 1.0;
    return {sign * edge.along(a), sign * edge.along(b), least};
}

}  // namespace rubble
