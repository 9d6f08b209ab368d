#include "core/geometry/search/Box3.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace rubble {

void Box3::include(Vec3 point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
}

void Box3::include(const Box3& box) {
    if (box.isEmpty()) return;
    include(box.min);
    include(box.max);
}

double Box3::diagonal() const { return isEmpty() ? 0.0 : glm::length(max - min); }

Vec3 Box3::corner(int index) const {
    return {(index & 1) != 0 ? max.x : min.x, (index & 2) != 0 ? max.y : min.y, (index & 4) != 0 ? max.z : min.z};
}

Box3 boxOf(Vec2 from, Vec2 to) { return {Vec3(glm::min(from, to), 0.0), Vec3(glm::max(from, to), 0.0)}; }

std::vector<Box3> boxesOf(std::span<const std::array<Vec2, 2>> edges) {
    std::vector<Box3> boxes;
    boxes.reserve(edges.size());
    for (const auto& [from, to] : edges) boxes.push_back(boxOf(from, to));
    return boxes;
}

}  // namespace rubble
