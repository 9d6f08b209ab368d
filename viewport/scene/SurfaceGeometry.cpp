#include "viewport/scene/SurfaceGeometry.h"

#include "viewport/scene/SolidBuilder.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

namespace rubble {
namespace {

constexpr double kFlatCosine = 0.99985;  // of one degree: a smaller crease is rounding error

/// An edge of a triangle, from the lower of its points to the higher.
struct SurfaceEdge {
    std::uint32_t low = 0, high = 0;
    std::uint32_t corner = 0;  // three per triangle
    auto ends() const { return std::tie(low, high); }
};

/// For each point the first equal one: files often give every triangle its own vertices.
std::vector<std::uint32_t> firstEquals(const std::vector<Vec3>& points) {
    const auto place = [&](std::uint32_t point) { return std::tie(points[point].x, points[point].y, points[point].z); };
    std::vector<std::uint32_t> order(points.size()), firsts(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool isNew = k == 0 || place(order[k - 1]) != place(order[k]);
        firsts[order[k]] = isNew ? order[k] : firsts[order[k - 1]];
    }
    return firsts;
}

std::vector<SurfaceEdge> sortedEdges(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> firsts = firstEquals(mesh.points);
    std::vector<SurfaceEdge> edges;
    for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
        const auto& triangle = mesh.triangles[corner / 3];
        const std::uint32_t from = firsts[triangle[corner % 3]], to = firsts[triangle[(corner + 1) % 3]];
        edges.push_back({std::min(from, to), std::max(from, to), corner});
    }
    std::ranges::sort(edges, [](const auto& a, const auto& b) {
        return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
    });
    return edges;
}

/// Unit normals; zero for degenerate triangles.
std::vector<Vec3> normalsOf(const TriangleMesh& mesh) {
    std::vector<Vec3> normals;
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const Vec3 area = doubleArea(mesh, triangle);
        const double length = glm::length(area);
        normals.push_back(length > 0.0 ? area / length : Vec3(0.0));
    }
    return normals;
}

/// Whether the edge from each corner to the next is visible.
std::vector<bool> shownEdges(const TriangleMesh& mesh, const std::vector<Vec3>& normals) {
    std::vector<bool> areShown(3 * mesh.triangles.size(), true);
    const std::vector<SurfaceEdge> edges = sortedEdges(mesh);
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t end = first + 1;
        while (end < edges.size() && edges[end].ends() == edges[first].ends()) ++end;
        if (end - first == 2) {
            const std::uint32_t a = edges[first].corner, b = edges[first + 1].corner;
            const bool isBend = std::abs(glm::dot(normals[a / 3], normals[b / 3])) < kFlatCosine;
            areShown[a] = areShown[b] = isBend;
        }
        first = end;
    }
    return areShown;
}

}  // namespace

void addSurface(SceneGeometry& geometry, const TriangleMesh& mesh) {
    const std::vector<Vec3> normals = normalsOf(mesh);
    const std::vector<bool> areShown = shownEdges(mesh, normals);
    SolidBuilder builder(geometry);
    for (std::size_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        const auto& points = mesh.triangles[triangle];
        const auto corner = [&](std::size_t k, std::size_t edge) {
            builder.addCorner(mesh.points[points[k]], Vec2(0.0), areShown[3 * triangle + edge]);
        };
        builder.beginFace(normals[triangle], VertexSide::Outside);
        for (std::size_t k = 0; k < 3; ++k) corner(k, k);
        builder.endFace();
        builder.beginFace(-normals[triangle], VertexSide::Inside);
        for (std::size_t k = 3; k-- > 0;) corner(k, (k + 2) % 3);
        builder.endFace();
    }
}

}  // namespace rubble
