#include "core/geometry/mesh/LatticeSurface.h"

#include "core/geometry/mesh/LatticeSigns.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <utility>

namespace rubble {

Box3 LatticeSurface::boxOf(std::uint32_t triangle) const {
    const Vec3 a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
    return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

void LatticeSurface::turnOver(std::span<const char> turned) {
    const auto renamed = [&](std::uint32_t halfEdge) {
        return turned[halfEdge / 3] ? halfEdge / 3 * 3 + (2 - halfEdge % 3) : halfEdge;
    };
    std::vector<std::uint32_t> result(across.size());
    for (std::uint32_t h = 0; h < across.size(); ++h) result[renamed(h)] = renamed(across[h]);
    across = std::move(result);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!turned[t]) continue;
        std::swap(triangles[t][1], triangles[t][2]);
        if (!views.empty()) views[t].sign = static_cast<std::int8_t>(-views[t].sign);
    }
}

LatticeSurface::View viewOf(Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 size = glm::abs(glm::cross(b - a, c - a));
    const int best = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    for (int k = 0; k < 3; ++k) {
        const int axis = (best + k) % 3, sign = areaSign(a, b, c, axis);
        if (sign != 0) return {static_cast<std::int8_t>(axis), static_cast<std::int8_t>(sign)};
    }
    return {};
}

}  // namespace rubble
