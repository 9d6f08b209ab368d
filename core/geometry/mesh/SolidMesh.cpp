#include "core/geometry/mesh/SolidMesh.h"

#include "core/base/DisjointSets.h"
#include "core/base/Index.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble {
namespace {

/// A triangle's edge; `low` < `high` are points.
struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    bool isAscending = false;  // whether the triangle's edge runs from low to high
    bool isSameAs(const Edge& other) const { return low == other.low && high == other.high; }
};

/// All edges, sorted by their points.
std::vector<Edge> edgesOf(const TriangleMesh& mesh) {
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t from = mesh.triangles[i][k], to = mesh.triangles[i][(k + 1) % 3];
            edges.push_back({std::min(from, to), std::max(from, to), i, from < to});
        }
    }
    std::ranges::sort(edges, [](const Edge& a, const Edge& b) {
        return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    });
    return edges;
}

std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

Error degenerate(std::string message) { return {ErrorCode::Degenerate, std::move(message)}; }

/// Checks that every edge has two triangles.
Status closure(const std::vector<Edge>& edges) {
    std::size_t open = 0, nonManifold = 0;
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && edges[end].isSameAs(edges[i])) ++end;
        open += end - i == 1;
        nonManifold += end - i > 2;
    }
    if (open > 0)
        return degenerate("The mesh is not closed: " + counted(open, "edge has", "edges have") + " one face only.");
    if (nonManifold > 0)
        return degenerate("The mesh is not manifold: " + counted(nonManifold, "edge has", "edges have") +
                          " more than two faces.");
    return success();
}

/// The triangle across an edge, and whether both use the edge in the same direction.
struct Neighbour {
    std::uint32_t triangle = 0;
    bool isSameDirection = false;
};

/// The three neighbours of each triangle of a closed mesh.
std::vector<std::array<Neighbour, 3>> neighboursOf(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
    std::vector<std::array<Neighbour, 3>> neighbours(mesh.triangles.size());
    std::vector<std::uint8_t> counts(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const std::uint32_t a = edges[i].triangle, b = edges[i + 1].triangle;
        const bool isSameDirection = edges[i].isAscending == edges[i + 1].isAscending;
        neighbours[a][counts[a]++] = {b, isSameDirection};
        neighbours[b][counts[b]++] = {a, isSameDirection};
    }
    return neighbours;
}

/// The triangles to flip so that all are oriented like the first.
Result<std::vector<char>> findFlips(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
    constexpr char kUnseen = 2;
    const std::vector<std::array<Neighbour, 3>> neighbours = neighboursOf(mesh, edges);
    std::vector<char> flips(mesh.triangles.size(), kUnseen);
    std::vector<std::uint32_t> open{0};
    flips[0] = 0;
    while (!open.empty()) {
        const std::uint32_t triangle = open.back();
        open.pop_back();
        for (const Neighbour next : neighbours[triangle]) {
            const char flip = flips[triangle] ^ static_cast<char>(next.isSameDirection);
            if (flips[next.triangle] == kUnseen) {
                flips[next.triangle] = flip;
                open.push_back(next.triangle);
            } else if (flips[next.triangle] != flip) {
                return degenerate("The mesh is not orientable: its faces cannot all be oriented the same way.");
            }
        }
    }
    if (std::ranges::find(flips, kUnseen) != flips.end())
        return degenerate("The mesh consists of parts that touch only at single points.");
    return flips;
}

double areaOf(const TriangleMesh& mesh) {
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) sum += glm::length(doubleArea(mesh, i)) / 2.0;
    return sum;
}

}  // namespace

double signedVolume(const TriangleMesh& mesh) {
    const Vec3 origin = mesh.points[mesh.triangles[0][0]];
    double sum = 0.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        sum += glm::dot(mesh.points[mesh.triangles[i][0]] - origin, doubleArea(mesh, i)) / 6.0;
    return sum;
}

std::vector<std::uint32_t> connectedParts(const TriangleMesh& mesh) {
    DisjointSets connectedPoints(mesh.points.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        connectedPoints.merge(a, b);
        connectedPoints.merge(a, c);
    }
    std::vector<std::uint32_t> numbers(mesh.points.size(), kNone), parts;
    std::uint32_t count = 0;
    for (const auto& triangle : mesh.triangles) {
        std::uint32_t& number = numbers[connectedPoints.rootOf(triangle[0])];
        if (number == kNone) number = count++;
        parts.push_back(number);
    }
    return parts;
}

Result<SolidMesh> orientedSolid(TriangleMesh mesh, double tolerance) {
    const std::vector<Edge> edges = edgesOf(mesh);
    if (const Status closed = closure(edges); !closed) return closed.error();
    const std::vector<std::uint32_t> parts = connectedParts(mesh);
    if (const std::uint32_t last = *std::ranges::max_element(parts); last > 0)
        return degenerate("The mesh consists of " + std::to_string(last + 1) + " disconnected parts.");
    Result<std::vector<char>> flips = findFlips(mesh, edges);
    if (!flips) return flips.error();
    const auto flip = [](std::array<std::uint32_t, 3>& triangle) { std::swap(triangle[1], triangle[2]); };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if ((*flips)[i]) flip(mesh.triangles[i]);
    SolidMesh solid{std::move(mesh), {}, 0.0};
    solid.volume = signedVolume(solid.mesh);
    if (std::abs(solid.volume) <= tolerance * areaOf(solid.mesh)) return degenerate("The mesh encloses no volume.");
    if (solid.volume < 0.0) {
        solid.volume = -solid.volume;
        std::ranges::for_each(solid.mesh.triangles, flip);
        for (char& isFlipped : *flips) isFlipped ^= 1;
    }
    for (std::uint32_t i = 0; i < flips->size(); ++i)
        if ((*flips)[i]) solid.flipped.push_back(i);
    return solid;
}

}  // namespace rubble
