#include "core/geometry/mesh/SolidMesh.h"

#include "core/base/DisjointSets.h"
#include "core/base/Index.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <span>
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

/// A face around an edge that runs from low to high.
struct Leaf {
    std::uint32_t triangle = 0;
    double angle = 0.0;       // radians, counter-clockwise seen against the edge
    bool opensSolid = false;  // whether solid follows it counter-clockwise
};

/// A direction perpendicular to another.
Vec3 anyAcross(Vec3 axis) {
    const Vec3 size = glm::abs(axis);
    Vec3 other{0.0, 0.0, 0.0};
    other[size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2] = 1.0;
    return glm::normalize(glm::cross(axis, other));
}

/// Sorts faces counter-clockwise; of those at the same angle, faces behind which a solid ends come first.
void sortAround(std::vector<Leaf>& leaves) {
    constexpr double kSameAngle = 1e-6;
    const auto byAngle = [](const Leaf& leaf) { return std::tie(leaf.angle, leaf.triangle); };
    const auto byEnd = [](const Leaf& leaf) { return std::tie(leaf.opensSolid, leaf.triangle); };
    std::ranges::sort(leaves, {}, byAngle);
    for (auto begin = leaves.begin(), end = begin; begin != leaves.end(); begin = end) {
        while (end != leaves.end() && end->angle - begin->angle <= kSameAngle) ++end;
        std::sort(begin, end, [&](const Leaf& a, const Leaf& b) { return byEnd(a) < byEnd(b); });
    }
}

/// The faces around an edge, sorted.
std::vector<Leaf> leavesOf(const TriangleMesh& mesh, std::span<const Edge> edges, bool isInverted) {
    constexpr double kRounding = 1e-9, kFullTurn = 6.283185307179586;
    const Vec3 low = mesh.points[edges[0].low];
    const Vec3 axis = glm::normalize(mesh.points[edges[0].high] - low), x = anyAcross(axis), y = glm::cross(axis, x);
    std::vector<Leaf> leaves;
    for (const Edge& edge : edges) {
        const auto [a, b, c] = mesh.triangles[edge.triangle];
        const Vec3 away = mesh.points[a] + mesh.points[b] + mesh.points[c] - 3.0 * low;
        const double angle = std::atan2(glm::dot(away, y), glm::dot(away, x));
        // Outside is where the normal points: ahead, counter-clockwise, if the triangle runs along the edge.
        leaves.push_back(
            {edge.triangle, angle < -kRounding ? angle + kFullTurn : angle, edge.isAscending == isInverted});
    }
    sortAround(leaves);
    return leaves;
}

/// Merges the triangles around an edge that have solid between them; none if windings contradict each other.
void mergeAround(const TriangleMesh& mesh, std::span<const Edge> edges, bool isInverted, DisjointSets& triangles) {
    if (edges.size() == 2) triangles.merge(edges[0].triangle, edges[1].triangle);
    if (edges.size() <= 2) return;
    const std::vector<Leaf> leaves = leavesOf(mesh, edges, isInverted);
    for (std::size_t i = 0; i < leaves.size(); ++i)
        if (leaves[i].opensSolid == leaves[(i + 1) % leaves.size()].opensSolid) return;
    for (std::size_t i = 0; i < leaves.size(); ++i)
        if (leaves[i].opensSolid) triangles.merge(leaves[i].triangle, leaves[(i + 1) % leaves.size()].triangle);
}

/// The part of each triangle, numbered by their first triangles.
std::vector<std::uint32_t> numbered(DisjointSets& triangles, std::size_t count) {
    std::vector<std::uint32_t> numbers(count, kNone), parts;
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        std::uint32_t& number = numbers[triangles.rootOf(i)];
        if (number == kNone) number = next++;
        parts.push_back(number);
    }
    return parts;
}

/// Whether each part of a component of a mesh is a solid: two of its triangles meet at each of its edges, and all parts
/// enclose a volume of the same sign.
std::vector<char> componentsOfSolids(const TriangleMesh& mesh, const std::vector<Edge>& edges,
                                     const std::vector<std::uint32_t>& parts,
                                     const std::vector<std::uint32_t>& components) {
    std::vector<char> areSolid(mesh.triangles.size(), 1);
    std::vector<std::uint32_t> around;
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        around.clear();
        for (; end < edges.size() && edges[end].isSameAs(edges[i]); ++end) around.push_back(parts[edges[end].triangle]);
        std::ranges::sort(around);
        for (std::size_t k = 0; k < around.size(); k += 2)
            if (k + 1 == around.size() || around[k] != around[k + 1] || (k > 0 && around[k - 1] == around[k]))
                areSolid[components[edges[i].triangle]] = 0;
    }
    std::vector<double> volumes(mesh.triangles.size(), 0.0);
    std::vector<std::uint32_t> componentOf(mesh.triangles.size(), kNone);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        // Relative to a point of the component, so that far ones are as exact.
        volumes[parts[i]] +=
            glm::dot(mesh.points[mesh.triangles[i][0]] - mesh.points[mesh.triangles[0][0]], doubleArea(mesh, i));
        componentOf[parts[i]] = components[i];
    }
    std::vector<double> signs(mesh.triangles.size(), 0.0);
    for (std::size_t part = 0; part < volumes.size() && componentOf[part] != kNone; ++part) {
        double& sign = signs[componentOf[part]];
        if (sign * volumes[part] < 0.0) areSolid[componentOf[part]] = 0;
        sign = volumes[part];
    }
    return areSolid;
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

std::vector<std::uint32_t> solidParts(const TriangleMesh& mesh) {
    const std::vector<std::uint32_t> components = connectedParts(mesh);
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    std::vector<double> volumes(count, 0.0);
    const Vec3 origin = mesh.points[mesh.triangles[0][0]];
    for (std::uint32_t i = 0; i < count; ++i)
        volumes[components[i]] += glm::dot(mesh.points[mesh.triangles[i][0]] - origin, doubleArea(mesh, i));
    const std::vector<Edge> edges = edgesOf(mesh);
    DisjointSets triangles(count);
    for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        while (end < edges.size() && edges[end].isSameAs(edges[i])) ++end;
        const bool isInverted = volumes[components[edges[i].triangle]] < 0.0;
        mergeAround(mesh, std::span(edges).subspan(i, end - i), isInverted, triangles);
    }
    const std::vector<std::uint32_t> parts = numbered(triangles, count);
    const std::vector<char> areSolid = componentsOfSolids(mesh, edges, parts, components);
    std::vector<std::uint32_t> first(count, kNone);
    for (std::uint32_t i = 0; i < count; ++i) {
        if (areSolid[components[i]]) continue;
        if (first[components[i]] == kNone) first[components[i]] = i;
        triangles.merge(first[components[i]], i);
    }
    return numbered(triangles, count);
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
