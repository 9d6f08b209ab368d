#include "core/geometry/hull/PolytopeTopology.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

namespace rubble {
namespace {

std::optional<Plane> planeOf(const std::vector<Vec3>& vertices, const std::vector<std::uint32_t>& face) {
    Vec3 normal(0.0), middle(0.0);
    const Vec3 first = vertices[face[0]];
    for (std::size_t k = 0; k < face.size(); ++k) {
        const Vec3 from = vertices[face[k]] - first, to = vertices[face[(k + 1) % face.size()]] - first;
        normal += glm::cross(from, to);
        middle += from;
    }
    const double length = glm::length(normal);
    if (!(length > 0.0)) return std::nullopt;
    normal /= length;
    return Plane{normal, glm::dot(normal, first + middle / static_cast<double>(face.size()))};
}

}  // namespace

std::optional<Polytope> polytopeOf(std::vector<Vec3> vertices, std::vector<std::vector<std::uint32_t>> faces) {
    Polytope polytope{.vertices = std::move(vertices), .faces = std::move(faces)};
    std::set<std::array<std::uint32_t, 2>> found;
    for (const std::vector<std::uint32_t>& face : polytope.faces) {
        const auto exists = [&](std::uint32_t vertex) { return vertex < polytope.vertices.size(); };
        if (face.size() < 3 || !std::ranges::all_of(face, exists)) return std::nullopt;
        const std::optional<Plane> plane = planeOf(polytope.vertices, face);
        if (!plane) return std::nullopt;
        polytope.planes.push_back(*plane);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const auto [low, high] = std::minmax(face[k], face[(k + 1) % face.size()]);
            if (found.insert({low, high}).second) polytope.edges.push_back({low, high});
        }
    }
    return polytope;
}

}  // namespace rubble
