#include "core/geometry/SolidMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace rubble {
namespace {

/// A triangle's edge; `low` < `high` are points.
struct Edge {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::uint32_t triangle = 0;
    bool runsUp = false;  // from low to high
    bool isSameAs(const Edge& other) const { return low == other.low && high == other.high; }
};

/// All edges, those between the same points beside each other.
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

/// Every edge lies between two triangles.
Status closure(const std::vector<Edge>& edges) {
    std::size_t open = 0, forked = 0;
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && edges[end].isSameAs(edges[i])) ++end;
        open += end - i == 1;
        forked += end - i > 2;
    }
    if (open > 0)
        return degenerate("The mesh is not closed: " + counted(open, "edge has", "edges have") + " one face only.");
    if (forked > 0)
        return degenerate("The mesh encloses no clear inside: " + counted(forked, "edge has", "edges have") +
                          " more than two faces.");
    return success();
}

/// The triangle across an edge, and whether the two run along it the same way.
struct Neighbour {
    std::uint32_t triangle = 0;
    bool runsTheSameWay = false;
};

/// The three neighbours of each triangle of a closed mesh.
std::vector<std::array<Neighbour, 3>> neighboursOf(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
    std::vector<std::array<Neighbour, 3>> neighbours(mesh.triangles.size());
    std::vector<std::uint8_t> counts(mesh.triangles.size(), 0);
    for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
        const std::uint32_t a = edges[i].triangle, b = edges[i + 1].triangle;
        const bool runsTheSameWay = edges[i].runsUp == edges[i + 1].runsUp;
        neighbours[a][counts[a]++] = {b, runsTheSameWay};
        neighbours[b][counts[b]++] = {a, runsTheSameWay};
    }
    return neighbours;
}

/// Which triangles must be turned so that all run the way the first does.
Result<std::vector<char>> turnsOf(const TriangleMesh& mesh, const std::vector<Edge>& edges) {
    constexpr char kUnseen = 2;
    const std::vector<std::array<Neighbour, 3>> neighbours = neighboursOf(mesh, edges);
    std::vector<char> turns(mesh.triangles.size(), kUnseen);
    std::vector<std::uint32_t> open{0};
    turns[0] = 0;
    while (!open.empty()) {
        const std::uint32_t triangle = open.back();
        open.pop_back();
        for (const Neighbour next : neighbours[triangle]) {
            const char turn = turns[triangle] ^ static_cast<char>(next.runsTheSameWay);
            if (turns[next.triangle] == kUnseen) {
                turns[next.triangle] = turn;
                open.push_back(next.triangle);
            } else if (turns[next.triangle] != turn) {
                return degenerate("The mesh has no outside: its faces cannot all be turned the same way.");
            }
        }
    }
    if (std::ranges::find(turns, kUnseen) != turns.end())
        return degenerate("The mesh consists of parts that touch in single points only.");
    return turns;
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

std::vector<std::uint32_t> partsOf(const TriangleMesh& mesh) {
    std::vector<std::uint32_t> parent(mesh.points.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t point) {
        while (parent[point] != point) point = parent[point] = parent[parent[point]];
        return point;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        parent[root(b)] = root(a);
        parent[root(c)] = root(a);
    }
    constexpr std::uint32_t kUnnumbered = 0xffffffffu;
    std::vector<std::uint32_t> numbers(mesh.points.size(), kUnnumbered), parts;
    std::uint32_t count = 0;
    for (const auto& triangle : mesh.triangles) {
        std::uint32_t& number = numbers[root(triangle[0])];
        if (number == kUnnumbered) number = count++;
        parts.push_back(number);
    }
    return parts;
}

Result<SolidMesh> solidOf(TriangleMesh mesh, double tolerance) {
    const std::vector<Edge> edges = edgesOf(mesh);
    if (const Status closed = closure(edges); !closed) return closed.error();
    const std::vector<std::uint32_t> parts = partsOf(mesh);
    if (const std::uint32_t last = *std::ranges::max_element(parts); last > 0)
        return degenerate("The mesh consists of " + std::to_string(last + 1) + " parts that are not joined.");
    Result<std::vector<char>> turns = turnsOf(mesh, edges);
    if (!turns) return turns.error();
    const auto turn = [](std::array<std::uint32_t, 3>& triangle) { std::swap(triangle[1], triangle[2]); };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if ((*turns)[i]) turn(mesh.triangles[i]);
    SolidMesh solid{std::move(mesh), {}, 0.0};
    solid.volume = signedVolume(solid.mesh);
    if (std::abs(solid.volume) <= tolerance * areaOf(solid.mesh)) return degenerate("The mesh encloses no volume.");
    if (solid.volume < 0.0) {
        solid.volume = -solid.volume;
        std::ranges::for_each(solid.mesh.triangles, turn);
        for (char& isTurned : *turns) isTurned ^= 1;
    }
    for (std::uint32_t i = 0; i < turns->size(); ++i)
        if ((*turns)[i]) solid.turned.push_back(i);
    return solid;
}

}  // namespace rubble
